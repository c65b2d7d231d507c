#include "scenarios/static3/sensor_scene.h"

#include <boost/random/poisson_distribution.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "scenarios/world/draws.h"

namespace mda {
namespace {

using Engine = boost::random::mt19937_64;

constexpr int kMostTargets = 100000;

int grid_side(int targets) { return static_cast<int>(std::lround(std::sqrt(targets))); }

/// The targets' positions.
std::vector<SensorReport> positions(const ThreeSensors& sensors, double side, Engine engine) {
  std::vector<SensorReport> targets;
  const int columns = grid_side(sensors.targets);
  for (int t = 0; t < sensors.targets; ++t) {
    const bool grid = sensors.layout == SensorLayout::kGrid;
    const int column = t % columns;
    const int row = t / columns;
    const double x = grid ? column + 0.5 : draw_uniform(engine, 0.0, side);
    const double y = grid ? row + 0.5 : draw_uniform(engine, 0.0, side);
    targets.push_back({x, y, t});
  }
  return targets;
}

void shuffle(std::vector<SensorReport>& reports, Engine engine) {
  for (std::size_t left = reports.size(); left > 1; --left) {
    std::swap(reports[left - 1], reports[engine() % left]);
  }
}

}  // namespace

std::string sensor_fault(const ScenarioSpec& spec) {
  const ThreeSensors& sensors = spec.three_sensors.value();
  const double detection = spec.world.detection_probability;
  const int side = grid_side(sensors.targets);
  if (sensors.targets < 1 || sensors.targets > kMostTargets) {
    return "targets: " + std::to_string(sensors.targets) + ": it must be 1 to " +
           std::to_string(kMostTargets) + ", or all sensors are empty";
  }
  if (sensors.layout == SensorLayout::kGrid && side * side != sensors.targets) {
    return "targets: " + std::to_string(sensors.targets) + " make no square grid";
  }
  if (!(sensors.sigma_per_spacing > 0.0 && sensors.sigma_per_spacing <= 10.0)) {
    return "sigma_per_spacing: it must be above 0 and at most 10";
  }
  if (!(detection > 0.0 && detection <= 1.0)) {
    return "detection_probability: it must be above 0 (or all sensors are empty) and at most 1";
  }
  if (!(sensors.false_alarms_per_target >= 0.0 && sensors.false_alarms_per_target <= 100.0)) {
    return "false_alarms_per_target: it must be 0 to 100";
  }
  if (!(spec.model.gate > 0.0)) return "gate: it must be above 0";
  return {};
}

SensorScene simulate_sensors(const ScenarioSpec& spec, std::uint64_t seed, int replicate) {
  if (!spec.three_sensors) throw std::invalid_argument(spec.name + " has no sensors");
  if (const std::string fault = sensor_fault(spec); !fault.empty()) {
    throw std::invalid_argument(fault);
  }
  const ThreeSensors& sensors = *spec.three_sensors;
  const std::string& stream = spec.draws_as.empty() ? spec.name : spec.draws_as;
  const auto keyed = [&](int sensor, Purpose purpose) {
    return draws({seed, stream, replicate, sensor, purpose});
  };
  SensorScene scene;
  scene.side = std::sqrt(sensors.targets);
  const auto targets = positions(sensors, scene.side, keyed(0, Purpose::kPositions));
  for (int s = 0; s < kSensors; ++s) {
    auto& reports = scene.reports[static_cast<std::size_t>(s)];
    Engine detections = keyed(s + 1, Purpose::kDetections);
    for (SensorReport report : targets) {
      const bool detected = draw_uniform(detections, 0.0, 1.0) < spec.world.detection_probability;
      report.x += draw_normal(detections, sensors.sigma_per_spacing);
      report.y += draw_normal(detections, sensors.sigma_per_spacing);
      if (detected) reports.push_back(report);
    }
    Engine false_alarms = keyed(s + 1, Purpose::kFalseAlarms);
    const double mean = sensors.false_alarms_per_target * sensors.targets;
    int left = mean > 0.0 ? boost::random::poisson_distribution<int>(mean)(false_alarms) : 0;
    for (; left > 0; --left) {
      const double x = draw_uniform(false_alarms, 0.0, scene.side);
      reports.push_back({x, draw_uniform(false_alarms, 0.0, scene.side), kNoTarget});
    }
    shuffle(reports, keyed(s + 1, Purpose::kReportOrder));
  }
  return scene;
}

}  // namespace mda
