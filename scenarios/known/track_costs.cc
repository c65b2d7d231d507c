#include "scenarios/known/track_costs.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "scenarios/hypotheses/track_forest.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Per km rad km/s.
double reference_density(const ScenarioSpec& spec, const PlotBox& box) {
  constexpr double kPerMetreRadianMetrePerSecond = 1e6;
  if (spec.known_targets->normalisation == CostNormalisation::kLiteral) {
    return kPerMetreRadianMetrePerSecond;
  }
  return std::max(spec.world.clutter_per_scan, kLeastClutterPerScan) / box.volume();
}

}  // namespace

StepCosts::StepCosts(const ScenarioSpec& spec, const PlotBox& clutter_box)
    : plot_covariance(doppler_plot_covariance(spec)),
      detection(std::log(reference_density(spec, clutter_box) / spec.world.detection_probability)),
      miss(-std::log(1.0 - spec.world.detection_probability)),
      gate(spec.model.gate) {}

TrackCosts::TrackCosts(const World& world, const StepCosts& steps, std::vector<Gaussian> base,
                       std::span<const KnownScan> scans)
    : world_(world), steps_(steps), base_(std::move(base)), first_row_{tracks()} {
  for (const KnownScan& scan : scans) {
    for (const DopplerPlot& plot : scan.plots) plots_.push_back(measurement_of(plot));
    first_row_.push_back(tracks() + static_cast<int>(plots_.size()));
  }
}

double TrackCosts::cost(const Tuple& tuple) const {
  double cost = 0.0;
  Gaussian state = base_[index(tuple.track)];
  for (const int row : tuple.rows) {
    state = predict(world_, state);
    if (row == kNoRow) {
      cost += steps_.miss;
      continue;
    }
    const DopplerInnovation expected = innovation(steps_.plot_covariance, state);
    cost += steps_.plot(expected, distance(expected, residual(expected, plot(row))));
    state = update(state, expected, plot(row));
  }
  return cost;
}

Gaussian TrackCosts::state(const Tuple& tuple, int scans) const {
  Gaussian state = base_[index(tuple.track)];
  for (int k = 0; k < scans; ++k) {
    state = predict(world_, state);
    const int row = tuple.rows[index(k)];
    if (row == kNoRow) continue;
    state = update(state, innovation(steps_.plot_covariance, state), plot(row));
  }
  return state;
}

int TrackCosts::first_row_from(int k, double range_km) const {
  const auto begin = plots_.begin() + (first_row(k) - tracks());
  const auto end = plots_.begin() + (first_row(k + 1) - tracks());
  const auto found = std::partition_point(
      begin, end, [&](const DopplerMeasurement& plot) { return plot(0) < range_km; });
  return tracks() + static_cast<int>(found - plots_.begin());
}

HypothesisTree TreeGrower::grow(const TrackCosts& costs) {
  HypothesisTree tree;
  tree.layer_begin.push_back(0);
  for (int track = 0; track < costs.tracks(); ++track) {
    add_node(tree, kNoNode, track, track, 0.0);
  }
  states_ = costs.base();
  for (int k = 1; k <= costs.scans(); ++k) {
    const int first = tree.layer_begin.back();
    const int last = tree.nodes();
    tree.layer_begin.push_back(last);
    next_.clear();
    for (int node = first; node < last; ++node) {
      add_children(costs, tree, node, states_[index(node - first)], k);
    }
    std::swap(states_, next_);
  }
  tree.layer_begin.push_back(tree.nodes());
  tree.column.assign(index(tree.nodes()), kNoColumn);
  index_children(tree);
  return tree;
}

void TreeGrower::add_children(const TrackCosts& costs, HypothesisTree& tree, int node,
                              const Gaussian& state, int k) {
  const StepCosts& steps = costs.steps();
  const bool leaves = k == costs.scans();
  const Gaussian predicted = predict(costs.world(), state);
  const DopplerInnovation expected = innovation(steps.plot_covariance, predicted);
  const double reach_km = std::sqrt(steps.gate * expected.covariance(0, 0));
  for (int row = costs.first_row_from(k, expected.plot(0) - reach_km);
       row < costs.first_row(k + 1) && costs.plot(row)(0) <= expected.plot(0) + reach_km; ++row) {
    const double d2 = distance(expected, residual(expected, costs.plot(row)));
    if (d2 > steps.gate) continue;
    add_node(tree, node, row, tree.track[index(node)], steps.plot(expected, d2));
    if (!leaves) next_.push_back(update(predicted, expected, costs.plot(row)));
  }
  add_node(tree, node, kNoRow, tree.track[index(node)], steps.miss);
  if (!leaves) next_.push_back(predicted);
}

void TreeGrower::add_node(HypothesisTree& tree, int parent, int row, int track, double step) {
  if (tree.nodes() - tree.layer_begin.back() >= kMostKnownLeaves) {
    throw std::runtime_error("the window has more than the " + std::to_string(kMostKnownLeaves) +
                             " hypotheses that are allowed");
  }
  tree.parent.push_back(parent);
  tree.row.push_back(row);
  tree.track.push_back(track);
  tree.step.push_back(step);
  tree.cost.push_back(parent == kNoNode ? step : tree.cost[index(parent)] + step);
}

}  // namespace mda
