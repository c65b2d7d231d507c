#include "scenarios/hypotheses/track_forest.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace mda {
namespace {

/// First node in [0, end) whose parent is `parent` or later.
int first_child_of(const Buffer<Node>& nodes, int end, int parent) {
  const Node* found =
      std::lower_bound(nodes.begin(), nodes.begin() + end, parent,
                       [](const Node& node, int wanted) { return node.parent < wanted; });
  return static_cast<int>(found - nodes.begin());
}

}  // namespace

void TrackForest::reset(const World& world, const TrackerModel& model, int window_k,
                        bool keeps_costs) {
  keeps_costs_ = keeps_costs;
  world_ = world;
  model_ = model;
  window_k_ = window_k;
  terms_ = cost_terms(world, model);
  lane_model_ = {world.range_sigma_km * world.range_sigma_km,
                 world.bearing_sigma_rad * world.bearing_sigma_rad, terms_.detection, model.gate};
  const double sigma = velocity_sigma(world, model);
  velocity_variance_ = sigma * sigma;
  least_plots_ = model.newborn == Newborn::kSinglePlot ? 1 : 2;

  noise_after_.clear();
  pair_noise_.assign(1, 0.0);
  for (int scans = 1; scans <= model.max_misses + 1; ++scans) {
    const AxisNoise q = process_noise(world, scans);
    const double t = scans * world.scan_period_s;
    noise_after_.push_back(q);
    pair_noise_.push_back(q.vv - 2.0 * q.pv / t + q.pp / (t * t));
  }

  newest_ = 0;
  fixed_ = 0;
  retired_cost_ = 0.0;
  hypotheses_ = 0;
  leaves_.set_size(0);
  layers_.resize(std::max(layers_.size(), static_cast<std::size_t>(window_k) + 1));
  posteriors_.resize(std::max(posteriors_.size(), static_cast<std::size_t>(model.max_misses) + 2));
}

Gaussian TrackForest::state_of(const Leaf& leaf) const {
  const LaneState packed = state_after_last_plot(leaf, newest_ - leaf.misses);
  Gaussian state;
  for (int row = 0, entry = 0; row < 4; ++row) {
    state.mean(row) = packed.x[row];
    for (int column = row; column < 4; ++column, ++entry) {
      state.covariance(row, column) = packed.p[entry];
      state.covariance(column, row) = packed.p[entry];
    }
  }
  for (int miss = 0; miss < leaf.misses; ++miss) state = predict(world_, state);
  return state;
}

void TrackForest::decide(std::span<const int> chosen) {
  if (newest_ <= window_k_) return;
  const int scan = newest_ - window_k_ + 1;
  find_survivors(scan, chosen);
  keep_survivors(scan);
  for (int below = scan + 1; below <= newest_; ++below) keep_descendants(below);
  fixed_ = scan;
}

/// Nodes of layer `scan` that chosen leaves descend from, ascending; retires what has ended.
void TrackForest::find_survivors(int scan, std::span<const int> chosen) {
  survivors_.clear();
  for (const int leaf : chosen) {
    const Leaf& end = leaves_[leaf];
    if (end.misses == kEnded && end.source <= scan) {
      retired_cost_ += end.cost;
      continue;
    }
    int node = leaf;
    for (int s = newest_; s > scan && node != kNoParent; --s) node = layer(s).nodes[node].parent;
    if (node != kNoParent) survivors_.push_back(node);
  }
  std::sort(survivors_.begin(), survivors_.end());
  if (std::adjacent_find(survivors_.begin(), survivors_.end()) != survivors_.end()) {
    throw std::logic_error("decide: two chosen hypotheses share a track in scan " +
                           std::to_string(scan));
  }
}

/// Within its layer, and gives it the parent's new number.
void TrackForest::move_node(int scan, int from, int to, int parent) {
  Layer& here = layer(scan);
  here.nodes[to] = {parent, here.nodes[from].plot};
  if (keeps_costs_) here.costs[to] = here.costs[from];
  if (scan == newest_) leaves_[to] = leaves_[from];
}

/// Makes the survivors the only nodes of layer `scan`: the fixed tracks.
void TrackForest::keep_survivors(int scan) {
  Buffer<Node>& nodes = layer(scan).nodes;
  kept_.clear();
  int out = 0;
  for (const int node : survivors_) {
    move_node(scan, node, out++, nodes[node].parent);
    if (!kept_.empty() && kept_.back().end == node) {
      kept_.back().end = node + 1;
    } else {
      kept_.push_back({node, node + 1});
    }
  }
  nodes.set_size(out);
  layer(scan).births_begin = out;
  if (scan == newest_) leaves_.set_size(out);
}

/// Keeps the children of the kept intervals of the layer above, and the births; then kept_ holds
/// the kept intervals of this layer.
void TrackForest::keep_descendants(int scan) {
  Layer& here = layer(scan);
  Buffer<Node>& nodes = here.nodes;
  below_.clear();
  int out = 0;
  const auto keep = [&](int begin, int end, int parent_shift) {
    if (begin == end) return;
    below_.push_back({begin, end});
    for (int i = begin; i < end; ++i, ++out) {
      move_node(scan, i, out, nodes[i].parent + parent_shift);
    }
  };
  int parents_before = 0;
  for (const Interval& parents : kept_) {
    keep(first_child_of(nodes, here.births_begin, parents.begin),
         first_child_of(nodes, here.births_begin, parents.end), parents_before - parents.begin);
    parents_before += parents.end - parents.begin;
  }
  const int births_begin = out;
  keep(here.births_begin, nodes.size(), 0);
  here.births_begin = births_begin;
  nodes.set_size(out);
  if (scan == newest_) leaves_.set_size(out);
  kept_.swap(below_);
}

}  // namespace mda
