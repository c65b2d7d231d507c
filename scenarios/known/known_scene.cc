#include "scenarios/known/known_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "scenarios/duration.h"
#include "scenarios/world/draws.h"

namespace mda {
namespace {

using Engine = boost::random::mt19937_64;

double wrapped(double bearing_rad) { return std::remainder(bearing_rad, 2.0 * std::numbers::pi); }

const KnownTargets& known_targets_of(const ScenarioSpec& spec) {
  if (!spec.known_targets) throw std::invalid_argument(spec.name + " has no known targets");
  return *spec.known_targets;
}

/// The same numbers are drawn whatever happens to the target.
void observe(const ScenarioSpec& spec, int target, Engine& engine, KnownScan& scan) {
  const double chance = draw_uniform(engine, 0.0, 1.0);
  const double range_error = draw_normal(engine, spec.world.range_sigma_km);
  const double bearing_error = draw_normal(engine, spec.world.bearing_sigma_rad);
  const double rate_error = draw_normal(engine, spec.known_targets->range_rate_sigma_km_s);
  const DopplerMeasurement exact = measured(scan.truth[static_cast<std::size_t>(target)]);
  scan.own.push_back({std::abs(exact(0) + range_error),
                      wrapped(exact(1) + bearing_error),
                      exact(2) + rate_error,
                      {target}});
  scan.detected.push_back(chance < spec.world.detection_probability);
}

void add_clutter(const World& world, const PlotBox& box, Engine& engine,
                 std::vector<DopplerPlot>& plots) {
  for (long n = std::lround(world.clutter_per_scan); n > 0; --n) {
    const double range = draw_uniform(engine, box.range_low_km, box.range_high_km);
    const double bearing = draw_uniform(engine, box.bearing_low_rad, box.bearing_high_rad);
    const double rate = draw_uniform(engine, box.range_rate_low_km_s, box.range_rate_high_km_s);
    plots.push_back({std::abs(range), wrapped(bearing), rate, {}});
  }
}

/// The number of the chain of unresolved plots that each plot is in.
std::vector<std::size_t> chains(const std::vector<DopplerPlot>& plots,
                                const KnownTargets& targets) {
  std::vector<std::size_t> chain(plots.size());
  std::iota(chain.begin(), chain.end(), std::size_t{0});
  for (std::size_t i = 0; i < plots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double range = std::abs(plots[i].range_km - plots[j].range_km);
      const double bearing = std::abs(wrapped(plots[i].bearing_rad - plots[j].bearing_rad));
      if (range >= targets.resolution_range_km || bearing >= targets.resolution_bearing_rad) {
        continue;
      }
      std::replace(chain.begin(), chain.end(), std::size_t{chain[i]}, std::size_t{chain[j]});
    }
  }
  return chain;
}

/// `members` are not empty; bearings are averaged around the first one's.
DopplerPlot mean_of(const std::vector<const DopplerPlot*>& members) {
  const auto count = static_cast<double>(members.size());
  DopplerPlot mean{0.0, 0.0, 0.0, {}};
  for (const DopplerPlot* plot : members) {
    mean.range_km += plot->range_km / count;
    mean.bearing_rad += wrapped(plot->bearing_rad - members[0]->bearing_rad) / count;
    mean.range_rate_km_s += plot->range_rate_km_s / count;
    mean.sources.insert(mean.sources.end(), plot->sources.begin(), plot->sources.end());
  }
  mean.bearing_rad = wrapped(mean.bearing_rad + members[0]->bearing_rad);
  std::ranges::sort(mean.sources);
  return mean;
}

std::vector<Gaussian> initial_estimates(const KnownTargets& targets, Engine engine) {
  const double position = targets.initial_position_sigma_km;
  const double velocity = targets.initial_velocity_sigma_km_s;
  std::vector<Gaussian> estimates;
  for (const TargetState& truth : true_states(targets, 0.0)) {
    Gaussian& estimate = estimates.emplace_back();
    estimate.mean << truth.x, truth.vx, truth.y, truth.vy;
    const Eigen::Array4d sigmas(position, velocity, position, velocity);
    for (int i = 0; i < 4; ++i) estimate.mean(i) += draw_normal(engine, sigmas(i));
    estimate.covariance = sigmas.square().matrix().asDiagonal();
  }
  return estimates;
}

}  // namespace

std::vector<DopplerPlot> resolved(const std::vector<DopplerPlot>& plots,
                                  const KnownTargets& targets) {
  const std::vector<std::size_t> chain = chains(plots, targets);
  std::vector<std::vector<const DopplerPlot*>> members(plots.size());
  for (std::size_t i = 0; i < plots.size(); ++i) members[chain[i]].push_back(&plots[i]);
  std::vector<DopplerPlot> seen;
  for (const auto& together : members) {
    if (together.size() == 1) seen.push_back(*together[0]);
    if (together.size() > 1) seen.push_back(mean_of(together));
  }
  std::ranges::sort(seen, [](const DopplerPlot& a, const DopplerPlot& b) {
    return std::tie(a.range_km, a.bearing_rad) < std::tie(b.range_km, b.bearing_rad);
  });
  return seen;
}

KnownScene simulate_known(const ScenarioSpec& spec, std::uint64_t seed, int replicate) {
  const KnownTargets& targets = known_targets_of(spec);
  const std::string& stream = spec.draws_as.empty() ? spec.name : spec.draws_as;
  KnownScene scene;
  scene.clutter_box = clutter_box(targets);
  scene.initial =
      initial_estimates(targets, draws({seed, stream, replicate, 0, Purpose::kInitialStates}));
  const int scans = scan_count(spec);
  for (int scan = 1; scan <= scans; ++scan) {
    KnownScan& now = scene.scans.emplace_back();
    now.truth = true_states(targets, scan * spec.world.scan_period_s);
    Engine detections = draws({seed, stream, replicate, scan, Purpose::kDetections});
    std::vector<DopplerPlot> plots;
    for (std::size_t i = 0; i < now.truth.size(); ++i) {
      observe(spec, static_cast<int>(i), detections, now);
      if (now.detected[i]) plots.push_back(now.own[i]);
    }
    Engine false_alarms = draws({seed, stream, replicate, scan, Purpose::kFalseAlarms});
    add_clutter(spec.world, scene.clutter_box, false_alarms, plots);
    now.plots = resolved(plots, targets);
  }
  return scene;
}

}  // namespace mda
