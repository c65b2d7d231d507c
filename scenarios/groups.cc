#include "scenarios/groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/cartesian/position_scene.h"
#include "scenarios/static3/sensor_points.h"

namespace mda {
namespace {

ScenarioSpec wide_group(std::string name, double clutter_per_scan, std::string summary) {
  ScenarioSpec spec{
      .name = std::move(name), .summary = std::move(summary), .world = {}, .model = {}};
  spec.world.clutter_per_scan = clutter_per_scan;
  return spec;
}

/// The paper does not say where the small square lies: at (33, 33) km the LP is about as often
/// fractional as published.
ScenarioSpec packed_group() {
  ScenarioSpec spec{.name = "D",
                    .summary = "slow targets from a square of 3 km side, closely spaced",
                    .world = {},
                    .model = {}};
  spec.world.speed_max_km_s = 0.5;
  spec.world.birth_centre_x_km = 33.0;
  spec.world.birth_centre_y_km = 33.0;
  spec.world.birth_side_km = 3.0;
  spec.world.births_per_scan = 3.0;
  spec.world.clutter_per_scan = 2.0;
  return spec;
}

/// Many targets on established tracks, fast enough to part: their LPs are nearly always integral.
/// The corner of the square that is farthest from the radar stays within its range. 50 m of noise
/// on each axis in its middle. Densities in one unit: as far out as this, the paper's would count a
/// false alarm as thirty times less likely than it is, and chains of them would be targets.
ScenarioSpec easy(int targets, double side_km, double clutter_per_scan) {
  constexpr double kCentre = 23.0;
  ScenarioSpec spec{
      .name = "easy-" + std::to_string(targets),
      .summary = std::to_string(targets) + " targets on established tracks, false alarms as many",
      .world = {},
      .model = {}};
  spec.world.scans = 12;
  spec.world.range_sigma_km = 0.05;
  spec.world.bearing_sigma_rad = 0.05 / std::hypot(kCentre, kCentre);
  spec.world.speed_max_km_s = 0.5;
  spec.world.birth_centre_x_km = kCentre;
  spec.world.birth_centre_y_km = kCentre;
  spec.world.birth_side_km = side_km;
  spec.world.initial_targets = targets;
  spec.world.clutter_per_scan = clutter_per_scan;
  spec.model.density = Density::kJacobian;
  return spec;
}

/// Slow targets, closer to each other than a gate is wide, whose velocity nobody knows: the denser,
/// the more columns, and the wider the gap between LP and optimum. 100 m of noise on each axis.
ScenarioSpec ladder(int targets, double side_km, double clutter_per_scan, int scans) {
  constexpr double kCentre = 33.0;
  ScenarioSpec spec{
      .name = "ladder-" + std::to_string(targets) + "-" + std::to_string(std::lround(side_km)),
      .summary = std::to_string(targets) + " slow targets of unknown velocity from a square of " +
                 std::to_string(std::lround(side_km)) + " km side",
      .world = {},
      .model = {}};
  spec.world.scans = scans;
  spec.world.range_sigma_km = 0.1;
  spec.world.bearing_sigma_rad = 0.1 / std::hypot(kCentre, kCentre);
  spec.world.speed_min_km_s = 0.0;
  spec.world.speed_max_km_s = 0.05;
  spec.world.birth_centre_x_km = kCentre;
  spec.world.birth_centre_y_km = kCentre;
  spec.world.birth_side_km = side_km;
  spec.world.initial_targets = targets;
  spec.world.births_per_scan = 3.0;
  spec.world.clutter_per_scan = clutter_per_scan;
  spec.model.velocity_prior = 1.0;
  return spec;
}

constexpr double kDegree = std::numbers::pi / 180.0;

/// What both scenes of Battistelli et al. 2008 have in common. The paper does not give its gate;
/// this one holds 99.9 % of true plots.
ScenarioSpec known_group(std::string name, std::string summary, const KnownTargets& targets) {
  ScenarioSpec spec{.name = std::move(name),
                    .summary = std::move(summary),
                    .world = {},
                    .model = {},
                    .known_targets = targets};
  spec.world.detection_probability = 0.8;
  spec.world.clutter_per_scan = 20.0;
  spec.world.births_per_scan = 0.0;
  spec.model.gate = 16.27;
  return spec;
}

/// Scenario 1. The targets fly straight; what the filter allows for is our choice.
ScenarioSpec platoons(std::string name, double spacing_km, std::string summary) {
  KnownTargets targets;
  targets.lateral_spacing_km = spacing_km;
  ScenarioSpec spec = known_group(std::move(name), std::move(summary), targets);
  spec.world.scans = 60;
  spec.world.scan_period_s = 5.0;
  spec.world.range_sigma_km = 0.015;
  spec.world.bearing_sigma_rad = 0.25 * kDegree;
  spec.world.acceleration_sigma_km_s2 = 3e-4;
  return spec;
}

/// Scenario 2. The targets turn with up to 1.7 m/s^2.
ScenarioSpec crossing(std::string name, double axis_degrees, std::string summary) {
  KnownTargets targets;
  targets.trajectories = Trajectories::kCrossing;
  targets.duration_s = 350.0;
  targets.axis_heading_rad = axis_degrees * kDegree;
  ScenarioSpec spec = known_group(std::move(name), std::move(summary), targets);
  spec.world.scans = 175;
  spec.world.scan_period_s = 2.0;
  spec.world.range_sigma_km = 0.05;
  spec.world.bearing_sigma_rad = 0.5 * kDegree;
  spec.world.acceleration_sigma_km_s2 = 1e-3;
  return spec;
}

/// For figure 9: battistelli-2 seen by a radar of `times` the resolution.
ScenarioSpec crossing_resolved(std::string name, double times, std::string summary) {
  ScenarioSpec spec = crossing(std::move(name), -30.0, std::move(summary));
  spec.known_targets->resolution_range_km *= times;
  spec.known_targets->resolution_bearing_rad *= times;
  spec.draws_as = "battistelli-2";
  return spec;
}

constexpr std::array<double, 4> kLeeDensities = {0.2, 0.4, 0.6, 0.8};

/// Lee & Jeong 1998, section IV. The paper gives neither its gate (this one holds 99 % of true
/// plots) nor the process noise of its filter (fitted to Table 3).
ScenarioSpec position_group(std::string name, std::string summary, const PositionTargets& targets,
                            double acceleration_sigma_km_s2) {
  ScenarioSpec spec{.name = std::move(name),
                    .summary = std::move(summary),
                    .world = {},
                    .model = {},
                    .position_targets = targets};
  spec.world.scans = 40;
  spec.world.scan_period_s = 1.0;
  spec.world.detection_probability = 0.7;
  spec.world.acceleration_sigma_km_s2 = acceleration_sigma_km_s2;
  spec.world.births_per_scan = 0.0;
  spec.world.clutter_per_scan = mean_clutter(targets);
  spec.model.gate = 9.21;
  return spec;
}

/// The four densities of Table 3 under both clutter laws, all with the draws of the first.
void add_pairs(const std::string& name, PositionScene scene, const std::string& what,
               std::vector<ScenarioSpec>& list) {
  for (const ClutterLaw law : {ClutterLaw::kAroundTargets, ClutterLaw::kUniform}) {
    for (const double density : kLeeDensities) {
      const bool uniform = law == ClutterLaw::kUniform;
      PositionTargets targets{.scene = scene};
      targets.clutter = law;
      targets.clutter_per_km2 = density;
      const std::string digits = std::to_string(density).substr(0, 3);
      std::string own_name = name;
      own_name.append(uniform ? "-uniform" : "");
      if (density > kLeeDensities[0]) own_name.append("-c").append(digits);
      std::string summary = what;
      summary.append(uniform ? ", clutter everywhere, " : ", clutter around them, ");
      summary.append(digits).append("/km2");
      list.push_back(position_group(std::move(own_name), std::move(summary), targets, 0.005));
      if (list.back().name != name) list.back().draws_as = name;
    }
  }
}

/// Table 4, at the density that the paper's figures have.
void add_ten(const std::string& name, ClutterLaw law, const std::string& draws_as,
             std::vector<ScenarioSpec>& list) {
  PositionTargets targets{.scene = PositionScene::kTen};
  targets.clutter = law;
  targets.clutter_per_km2 = kLeeDensities[0];
  targets.manoeuvres = ManoeuvreModel::kSinger;
  const bool uniform = law == ClutterLaw::kUniform;
  list.push_back(position_group(name,
                                std::string("ten targets, two manoeuvre, clutter ") +
                                    (uniform ? "everywhere" : "around them"),
                                targets, 0.01));
  list.back().draws_as = draws_as;
}

std::vector<ScenarioSpec> make_scenario_list() {
  std::vector<ScenarioSpec> list = {
      wide_group("A", 1.0, "targets all over the coverage, 1 false alarm per scan"),
      wide_group("B", 5.0, "targets all over the coverage, 5 false alarms per scan"),
      wide_group("C", 25.0, "targets all over the coverage, 25 false alarms per scan"),
      packed_group(),
      platoons("battistelli-1", 0.25, "two platoons of 10 targets, 250 m apart, pass each other"),
      platoons("battistelli-1-dense", 0.15, "battistelli-1 with 150 m between neighbours"),
      platoons("battistelli-1-wide", 0.4, "battistelli-1 with 400 m between neighbours"),
      crossing("battistelli-2", -30.0, "3 manoeuvring targets meet twice, Doppler separates them"),
      crossing("battistelli-2-radial", -90.0, "battistelli-2 flying at the radar: equal Doppler"),
      crossing_resolved("battistelli-2-res0.01", 0.01,
                        "battistelli-2 with 0.5 m, 0.01 deg resolution"),
      crossing_resolved("battistelli-2-res2", 2.0, "battistelli-2 with 100 m, 2 deg resolution"),
      crossing_resolved("battistelli-2-res4", 4.0, "battistelli-2 with 200 m, 4 deg resolution"),
  };
  list.insert(list.end(), {easy(50, 10.0, 50.0), easy(100, 10.0, 100.0), easy(200, 20.0, 200.0)});
  list.insert(list.end(),
              {ladder(40, 6.0, 5.0, 4), ladder(40, 5.0, 5.0, 4), ladder(40, 4.0, 5.0, 4),
               ladder(60, 7.0, 10.0, 5), ladder(100, 10.0, 20.0, 6), ladder(40, 8.0, 5.0, 8),
               ladder(40, 10.0, 5.0, 10)});
  add_pairs("lee-crossing", PositionScene::kCrossing, "2 crossing targets", list);
  add_pairs("lee-parallel", PositionScene::kParallel, "2 targets side by side", list);
  add_ten("lee-ten", ClutterLaw::kAroundTargets, "", list);
  add_ten("lee-ten-uniform", ClutterLaw::kUniform, "lee-ten", list);
  std::ranges::move(sensor_points(), std::back_inserter(list));
  return list;
}

}  // namespace

std::span<const ScenarioSpec> scenario_list() {
  static const std::vector<ScenarioSpec> kScenarios = make_scenario_list();
  return kScenarios;
}

const ScenarioSpec* find_scenario(std::string_view name) {
  for (const ScenarioSpec& spec : scenario_list()) {
    if (spec.name == name) return &spec;
  }
  return nullptr;
}

}  // namespace mda
