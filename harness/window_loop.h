// Slides the window over a scene: grow by a scan, freeze the window, let an answer advance it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "harness/clocks.h"
#include "scenarios/hypotheses/extract.h"
#include "scenarios/hypotheses/track_forest.h"
#include "scenarios/hypotheses/truth_cost.h"
#include "scenarios/world/simulate.h"

namespace mda {

/// Keeps its memory from one start to the next. One object per thread.
class WindowLoop {
 public:
  /// Simulates the scene anew and stands before its first scan.
  void start(const ScenarioSpec& spec, std::uint64_t seed, int replicate, int window_k);

  /// Goes on to the window of the next scan; false after the last one. advance() must have been
  /// called since the last next().
  bool next();

  [[nodiscard]] const WindowInstance& window() const noexcept { return window_; }
  /// Scan N of window(), counted from 1.
  [[nodiscard]] int scan() const noexcept { return forest_.newest_scan(); }

  /// V_T: cost of the true tracks up to scan(), nats.
  [[nodiscard]] double truth_cost() const { return truth_.cost(); }

  [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
  [[nodiscard]] const TrackForest& forest() const noexcept { return forest_; }

  /// The leaves that the answer `x` to window() chooses.
  [[nodiscard]] std::vector<int> chosen_leaves(std::span<const double> x) const;

  /// Fixes what leaves the window as the answer `x` (0 or 1 for every column, no row broken) says.
  void advance(std::span<const double> x);

  /// CPU time of the simulation, milliseconds.
  [[nodiscard]] double simulate_cpu_ms() const noexcept { return simulate_cpu_ms_; }
  /// Growing, extracting and deciding that made window() out of the one before: wall clock and CPU
  /// time, milliseconds.
  [[nodiscard]] double grow_ms() const noexcept { return grow_.wall_ms; }
  [[nodiscard]] double grow_cpu_ms() const noexcept { return grow_.cpu_ms; }

 private:
  Scene scene_;
  TrackForest forest_;
  TruthCost truth_;
  WindowExtractor extractor_;
  WindowInstance window_;
  double simulate_cpu_ms_ = 0.0;
  Elapsed grow_;
  Elapsed decide_;
};

}  // namespace mda
