// Slides the window over a scene: grow by a scan, freeze the window, let an answer advance it.
#pragma once

#include <cstdint>
#include <optional>

#include "harness/association_counts.h"
#include "harness/clocks.h"
#include "harness/judge.h"
#include "scenarios/hypotheses/extract.h"
#include "scenarios/spec.h"

namespace mda {

/// Objects keep their memory from one start to the next. One object per thread.
class WindowLoop {
 public:
  WindowLoop() = default;
  WindowLoop(const WindowLoop&) = delete;
  WindowLoop& operator=(const WindowLoop&) = delete;
  virtual ~WindowLoop() = default;

  /// Simulates the scene anew and stands before its first scan. `views`: the windows come with
  /// their views.
  virtual void start(const ScenarioSpec& spec, std::uint64_t seed, int replicate, int window_k,
                     bool views) = 0;

  /// Goes on to the window of the next scan; false after the last one. advance() must have been
  /// called since the last next().
  virtual bool next() = 0;

  /// Fixes what leaves the window as `decision` (no row broken) says.
  virtual void advance(const Decision& decision) = 0;

  /// Scan N of window(), counted from 1.
  [[nodiscard]] virtual int scan() const noexcept = 0;

  /// V_T: cost of the true tracks up to scan(), nats, where there is such a thing.
  [[nodiscard]] virtual std::optional<double> truth_cost() const = 0;

  /// How well a choice (no row broken, an x for every column) agrees with the truth, where columns
  /// are tuples of reports that are one target or not.
  [[nodiscard]] virtual std::optional<AssociationCounts> association(
      const Solution& /*solution*/) const {
    return std::nullopt;
  }

  [[nodiscard]] const WindowInstance& window() const noexcept { return window_; }

  /// CPU time of the simulation, milliseconds.
  [[nodiscard]] double simulate_cpu_ms() const noexcept { return simulate_cpu_ms_; }
  /// Growing, extracting and deciding that made window() out of the one before: wall clock and CPU
  /// time, milliseconds.
  [[nodiscard]] double grow_ms() const noexcept { return grow_.wall_ms; }
  [[nodiscard]] double grow_cpu_ms() const noexcept { return grow_.cpu_ms; }
  /// Making the views: wall clock, milliseconds, not part of grow_ms(); its CPU time is part of
  /// grow_cpu_ms().
  [[nodiscard]] double views_ms() const noexcept { return views_ms_; }

 protected:
  WindowInstance window_;
  double simulate_cpu_ms_ = 0.0;
  Elapsed grow_;
  double views_ms_ = 0.0;
};

}  // namespace mda
