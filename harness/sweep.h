// A sweep: which windows are made, and which algorithms solve them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/spec.h"

namespace mda {

/// A scenario's part of a sweep. A sweep may have several of one scenario, as long as no cell is
/// there twice.
struct ScenarioPlan {
  ScenarioSpec spec;
  std::vector<int> windows;                  ///< K, each >= 1
  int replicates = 1;                        ///< the last one
  std::vector<double> scan_periods_s = {};   ///< empty: the sweep's
  std::vector<std::string> algorithms = {};  ///< empty: the sweep's
  /// Open loop: the driver's answers advance the windows, and all algorithms see the same ones.
  /// Closed loop: every algorithm's own answers advance its own windows.
  bool closed_loop = false;
  int every = 1;  ///< open loop: only every so many-th scan's window is for the algorithms
  /// Above 1: continues a part of the same scenario whose replicates end before it.
  int first_replicate = 1;
};

struct Sweep {
  std::string name;
  std::string summary;  ///< one line for people
  std::vector<ScenarioPlan> scenarios;
  std::vector<double> scan_periods_s = {8.0};
  std::uint64_t seed = 1;
  std::string driver;  ///< the algorithm whose answers advance the windows
  std::vector<std::string> algorithms;
  double time_limit_s = 10.0;  ///< wall clock, per solve
  /// A short solve is repeated so often, and its least times count: those with a warm cache.
  int repeats = 1;
};

inline constexpr int kMostRepeats = 1000;

/// The plan's own, or the sweep's.
[[nodiscard]] const std::vector<double>& scan_periods_of(const Sweep& sweep,
                                                         const ScenarioPlan& plan);
[[nodiscard]] const std::vector<std::string>& algorithms_of(const Sweep& sweep,
                                                            const ScenarioPlan& plan);

/// What the command line may say instead of the sweep; empty or 0 leaves the sweep's own.
struct SweepChanges {
  std::vector<std::string> algorithms;
  std::vector<std::string> scenarios;
  std::vector<int> windows;
  std::vector<double> scan_periods_s;
  int replicates = 0;
  std::uint64_t seed = 0;
  double time_limit_s = 0.0;
  int repeats = 0;
  bool closed_loop = false;  ///< all of it
};

/// The named sweeps.
[[nodiscard]] const std::vector<Sweep>& named_sweeps();

/// A named sweep, or the one in a TOML file if `name` ends in ".toml". Throws InputError.
[[nodiscard]] Sweep load_sweep(const std::string& name);

/// A sweep from a TOML text; `file` is for messages. Throws InputError with the line.
[[nodiscard]] Sweep parse_sweep(std::string_view text, const std::string& file);

/// A scenario that the sweep does not have gets the windows and replicates of its first one.
/// Throws InputError for unknown names and values out of range.
[[nodiscard]] Sweep changed(Sweep sweep, const SweepChanges& changes);

/// Throws InputError if a name is unknown, a list is empty or names something twice, or a value is
/// out of range; `where` begins the message.
void check(const Sweep& sweep, const std::string& where);

/// The scenario of that name, or an InputError that begins with `where` and lists the names there
/// are.
[[nodiscard]] const ScenarioSpec& scenario_named(std::string_view name,
                                                 std::string_view where = {});

}  // namespace mda
