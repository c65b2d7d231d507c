// The named scenarios of three sensors.
#pragma once

#include <vector>

#include "scenarios/spec.h"

namespace mda {

/// A point of the study: `static3-36-s0.20-f0.1` has a grid of 36 targets, reports with 0.2 mean
/// target distances of standard deviation, and 0.1 false alarms per target and sensor;
/// `static3-36-random-...` has its targets anywhere.
[[nodiscard]] ScenarioSpec sensor_point(int targets, SensorLayout layout, double sigma_per_spacing,
                                        double false_alarms_per_target);

/// The 30 points of figure 2 in Bojilov 1995 with false alarms beside it, which the paper does not
/// vary: grids of 36 and 64 targets, sigma 0.1, 0.15, 0.2, 0.25 and 0.3, false alarms 0, 0.1 and
/// 0.3 per target.
[[nodiscard]] std::vector<ScenarioSpec> sensor_grid_points();

/// Those, and four with random layouts.
[[nodiscard]] std::vector<ScenarioSpec> sensor_points();

}  // namespace mda
