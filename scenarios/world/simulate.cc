#include "scenarios/world/simulate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "scenarios/world/draws.h"

namespace mda {
namespace {

using Engine = boost::random::mt19937_64;

struct Target {
  TargetState state;
  int birth_scan = 0;
};

Target newborn(const World& world, int scan, Engine& engine) {
  const double half = 0.5 * world.birth_side_km;
  Target target;
  target.birth_scan = scan;
  target.state.x = world.birth_centre_x_km + draw_uniform(engine, -half, half);
  target.state.y = world.birth_centre_y_km + draw_uniform(engine, -half, half);
  const double speed = draw_uniform(engine, world.speed_min_km_s, world.speed_max_km_s);
  const double heading = draw_uniform(engine, -std::numbers::pi, std::numbers::pi);
  target.state.vx = speed * std::cos(heading);
  target.state.vy = speed * std::sin(heading);
  return target;
}

void move(const World& world, TargetState& s, Engine& engine) {
  const double t = world.scan_period_s;
  const double ax = draw_normal(engine, world.acceleration_sigma_km_s2);
  const double ay = draw_normal(engine, world.acceleration_sigma_km_s2);
  s.x += t * (s.vx + 0.5 * t * ax);
  s.y += t * (s.vy + 0.5 * t * ay);
  s.vx += t * ax;
  s.vy += t * ay;
}

/// Draws the same numbers whether the target is in range or not, so that a change of the scan
/// period does not shift the draws of the targets after it.
void observe(const World& world, const TruePosition& true_position, Engine& engine,
             std::vector<Plot>& plots) {
  const bool seen = draw_uniform(engine, 0.0, 1.0) < world.detection_probability;
  const double range_error = draw_normal(engine, world.range_sigma_km);
  const double bearing_error = draw_normal(engine, world.bearing_sigma_rad);
  const TargetState& s = true_position.state;
  const double range = std::hypot(s.x, s.y);
  if (!seen || range > world.range_km) return;
  const double bearing = std::atan2(s.y, s.x) + bearing_error;
  plots.push_back({std::abs(range + range_error), std::remainder(bearing, 2.0 * std::numbers::pi),
                   true_position.target});
}

void add_false_alarms(const World& world, Engine& engine, std::vector<Plot>& plots) {
  const int count = draw_poisson(engine, world.clutter_per_scan);
  for (int i = 0; i < count; ++i) {
    const double range = world.range_km * std::sqrt(draw_uniform(engine, 0.0, 1.0));
    plots.push_back(
        {range, draw_uniform(engine, -std::numbers::pi, std::numbers::pi), kFalseAlarm});
  }
}

bool lives(const World& world, const Target& target, int scan) {
  return world.target_life_scans == 0 || scan < target.birth_scan + world.target_life_scans;
}

}  // namespace

Scene simulate(const ScenarioSpec& spec, std::uint64_t seed, int replicate) {
  const World& world = spec.world;
  const auto stream = [&](int scan, Purpose purpose) {
    return draws({seed, spec.name, replicate, scan, purpose});
  };
  Scene scene;
  std::vector<Target> targets;
  for (int scan = 1; scan <= world.scans; ++scan) {
    Engine motion = stream(scan, Purpose::kMotion);
    for (Target& target : targets) move(world, target.state, motion);
    Engine births = stream(scan, Purpose::kBirths);
    const int initial = scan == 1 ? world.initial_targets : 0;
    for (int n = draw_poisson(births, world.births_per_scan) + initial; n > 0; --n) {
      targets.push_back(newborn(world, scan, births));
    }
    Scan& now = scene.scans.emplace_back();
    Engine detections = stream(scan, Purpose::kDetections);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (!lives(world, targets[i], scan)) continue;
      now.truth.push_back({static_cast<int>(i), targets[i].state});
      observe(world, now.truth.back(), detections, now.plots);
    }
    Engine false_alarms = stream(scan, Purpose::kFalseAlarms);
    add_false_alarms(world, false_alarms, now.plots);
    std::sort(now.plots.begin(), now.plots.end(), [](const Plot& a, const Plot& b) {
      return std::tie(a.range_km, a.bearing_rad) < std::tie(b.range_km, b.bearing_rad);
    });
  }
  scene.targets = static_cast<int>(targets.size());
  return scene;
}

}  // namespace mda
