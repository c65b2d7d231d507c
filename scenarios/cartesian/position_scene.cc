#include "scenarios/cartesian/position_scene.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <string>

#include "scenarios/cartesian/trajectories.h"
#include "scenarios/duration.h"
#include "scenarios/world/draws.h"

namespace mda {
namespace {

using Engine = boost::random::mt19937_64;

/// Normal, or with sigma 0 nothing.
Eigen::Vector2d draw_offset(Engine& engine, double sigma_km) {
  const double x = draw_normal(engine, sigma_km);
  return {x, draw_normal(engine, sigma_km)};
}

Eigen::Vector2d position_of(const TargetState& state) { return {state.x, state.y}; }

std::vector<FirstLooks> first_looks(const ScenarioSpec& spec, Engine engine) {
  const PositionTargets& targets = *spec.position_targets;
  const std::vector<TargetState> before = true_states(targets, -spec.world.scan_period_s);
  const std::vector<TargetState> now = true_states(targets, 0.0);
  std::vector<FirstLooks> looks;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Eigen::Vector2d first = draw_offset(engine, targets.plot_sigma_km);
    const Eigen::Vector2d second = draw_offset(engine, targets.plot_sigma_km);
    looks.push_back({position_of(before[i]) + first, position_of(now[i]) + second});
  }
  return looks;
}

/// The same numbers are drawn whatever happens to the targets.
void observe(const ScenarioSpec& spec, bool quiet, Engine engine, PositionScan& scan) {
  for (std::size_t i = 0; i < scan.truth.size(); ++i) {
    const double chance = draw_uniform(engine, 0.0, 1.0);
    const Eigen::Vector2d error = draw_offset(engine, spec.position_targets->plot_sigma_km);
    scan.own.emplace_back(position_of(scan.truth[i]) + error);
    scan.detected.push_back(quiet || chance < spec.world.detection_probability);
    if (scan.detected.back()) scan.plots.push_back({scan.own.back(), static_cast<int>(i)});
  }
}

/// Mean number of plots in the cloud of one target.
double mean_of_cloud(const PositionTargets& targets) {
  const double spread = targets.clutter_spread_km;
  return targets.clutter_per_km2 * 2.0 * std::numbers::pi * spread * spread;
}

void add_clutter(const PositionTargets& targets, Engine engine, PositionScan& scan) {
  if (targets.clutter == ClutterLaw::kUniform) {
    const double half = 0.5 * targets.area_side_km;
    for (int n = draw_poisson(engine, mean_clutter(targets)); n > 0; --n) {
      const double x = draw_uniform(engine, -half, half);
      scan.plots.push_back({{x, draw_uniform(engine, -half, half)}, kFalseAlarm});
    }
    return;
  }
  for (const TargetState& truth : scan.truth) {
    for (int n = draw_poisson(engine, mean_of_cloud(targets)); n > 0; --n) {
      scan.plots.push_back(
          {position_of(truth) + draw_offset(engine, targets.clutter_spread_km), kFalseAlarm});
    }
  }
}

}  // namespace

double mean_clutter(const PositionTargets& targets) {
  if (targets.clutter == ClutterLaw::kUniform) {
    return targets.clutter_per_km2 * targets.area_side_km * targets.area_side_km;
  }
  return mean_of_cloud(targets) * static_cast<double>(target_numbers(targets.scene).size());
}

PositionRun simulate_positions(const ScenarioSpec& spec, std::uint64_t seed, int replicate) {
  if (!spec.position_targets) throw std::invalid_argument(spec.name + " has no position targets");
  const PositionTargets& targets = *spec.position_targets;
  const std::string& stream = spec.draws_as.empty() ? spec.name : spec.draws_as;
  const auto engine = [&](int scan, Purpose purpose) {
    return draws({seed, stream, replicate, scan, purpose});
  };
  PositionRun run;
  run.looks = first_looks(spec, engine(0, Purpose::kInitialStates));
  const int scans = scan_count(spec);
  for (int scan = 1; scan <= scans; ++scan) {
    PositionScan& now = run.scans.emplace_back();
    const bool quiet = scan <= targets.quiet_scans;
    now.truth = true_states(targets, scan * spec.world.scan_period_s);
    observe(spec, quiet, engine(scan, Purpose::kDetections), now);
    if (!quiet) add_clutter(targets, engine(scan, Purpose::kFalseAlarms), now);
    std::ranges::sort(now.plots, [](const PositionPlot& a, const PositionPlot& b) {
      return a.position.x() < b.position.x() ||
             (a.position.x() == b.position.x() && a.position.y() < b.position.y());
    });
  }
  return run;
}

}  // namespace mda
