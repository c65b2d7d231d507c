// Monte Carlo scenes of targets seen as positions (Lee & Jeong 1998, section IV): the trajectories
// are fixed; noise, missed detections and clutter are drawn.
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <vector>

#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

struct PositionPlot {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< km
  int source = kFalseAlarm;  ///< target, counted from 0 in its scene; known to the metrics only
};

/// Plots are in the order of their x: no order tells of their source.
struct PositionScan {
  std::vector<PositionPlot> plots;
  std::vector<TargetState> truth;    ///< [target]
  std::vector<Eigen::Vector2d> own;  ///< [target]: its plot, whether it is detected or not
  std::vector<bool> detected;        ///< [target]
};

/// What tracks begin with: a target's plots in two looks before the first scan.
struct FirstLooks {
  Eigen::Vector2d before;  ///< one scan period before time 0
  Eigen::Vector2d now;     ///< at time 0
};

struct PositionRun {
  std::vector<PositionScan> scans;  ///< [scan - 1]; scan n is taken at n scan periods
  std::vector<FirstLooks> looks;    ///< [target]
};

/// Mean number of clutter plots in a scan that is not quiet.
[[nodiscard]] double mean_clutter(const PositionTargets& targets);

/// The scene of one replicate (counted from 1). Depends on (seed, draws_as or else the name,
/// replicate), the world and the targets. Every target draws the same numbers whether it is
/// detected or not, and whatever clutter there is. O(scans x plots log plots). Throws
/// std::invalid_argument if the scenario has no position targets.
[[nodiscard]] PositionRun simulate_positions(const ScenarioSpec& spec, std::uint64_t seed,
                                             int replicate);

}  // namespace mda
