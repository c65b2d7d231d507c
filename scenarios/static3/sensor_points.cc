#include "scenarios/static3/sensor_points.h"

#include <cstdio>
#include <string>

namespace mda {
namespace {

/// Wide enough to cut off no tuple of negative cost at any of the points.
constexpr double kGate = 30.0;

std::string text(const char* format, double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

}  // namespace

ScenarioSpec sensor_point(int targets, SensorLayout layout, double sigma_per_spacing,
                          double false_alarms_per_target) {
  const bool grid = layout == SensorLayout::kGrid;
  const std::string sigma = text("%.2f", sigma_per_spacing);
  const std::string alarms = text("%.1f", false_alarms_per_target);
  ScenarioSpec spec{
      .name = "static3-" + std::to_string(targets) + (grid ? "-s" : "-random-s") + sigma + "-f" +
              alarms,
      .summary = "three sensors, " + std::to_string(targets) + " targets" +
                 (grid ? " on a grid" : " anywhere") + ", sigma " + sigma + " of their distance, " +
                 alarms + " false alarms each",
      .world = {},
      .model = {},
      .three_sensors = ThreeSensors{.targets = targets,
                                    .layout = layout,
                                    .sigma_per_spacing = sigma_per_spacing,
                                    .false_alarms_per_target = false_alarms_per_target}};
  spec.world.scans = 1;
  spec.world.scan_period_s = 1.0;
  spec.world.births_per_scan = 0.0;
  spec.world.clutter_per_scan = 0.0;
  spec.world.detection_probability = 0.7;
  spec.model.gate = kGate;
  return spec;
}

std::vector<ScenarioSpec> sensor_grid_points() {
  std::vector<ScenarioSpec> points;
  for (const int targets : {36, 64}) {
    for (const double sigma : {0.1, 0.15, 0.2, 0.25, 0.3}) {
      for (const double alarms : {0.0, 0.1, 0.3}) {
        points.push_back(sensor_point(targets, SensorLayout::kGrid, sigma, alarms));
      }
    }
  }
  return points;
}

std::vector<ScenarioSpec> sensor_points() {
  std::vector<ScenarioSpec> points = sensor_grid_points();
  for (const int targets : {36, 64}) {
    for (const double sigma : {0.15, 0.2}) {
      points.push_back(sensor_point(targets, SensorLayout::kRandom, sigma, 0.1));
    }
  }
  return points;
}

}  // namespace mda
