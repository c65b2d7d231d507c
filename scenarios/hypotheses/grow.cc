// TrackForest::grow: expands only the newest layer, a block of lanes at a time.

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <string>

#include "scenarios/hypotheses/track_forest.h"

namespace mda {

namespace {

/// A plot's bearing minus the expected one, in [-pi, pi].
double bearing_residual(double plot, double expected) {
  constexpr double kPi = std::numbers::pi;
  double difference = plot - expected;
  difference = difference > kPi ? difference - 2.0 * kPi : difference;
  return difference < -kPi ? difference + 2.0 * kPi : difference;
}

}  // namespace

void TrackForest::grow(const Scan& scan) {
  if (newest_ > window_k_ && fixed_ != newest_ - window_k_ + 1) {
    throw std::logic_error("grow: scan " + std::to_string(newest_) + " has not been decided");
  }
  ++newest_;
  if (scans_.size() < static_cast<std::size_t>(newest_)) scans_.emplace_back();
  IndexedScan& now = scans_[scan_index(newest_)];
  now.assign(world_, model_, scan);
  layer(newest_).nodes.set_size(0);
  posteriors(newest_).set_size(0);
  next_.set_size(0);
  for (int begin = 0; begin < leaves_.size(); begin += kLanes) {
    expand_block(now, begin, std::min(begin + kLanes, leaves_.size()));
  }
  append_births(now);
  leaves_.swap(next_);
  if (leaves_.size() > kMostLeaves) {
    throw std::runtime_error("scan " + std::to_string(newest_) + " has " +
                             std::to_string(leaves_.size()) + " hypotheses, more than the " +
                             std::to_string(kMostLeaves) + " that are allowed");
  }
  if (keeps_costs_) store_costs();
}

void TrackForest::store_costs() {
  Buffer<double>& costs = layer(newest_).costs;
  costs.set_size(0);
  costs.make_room(leaves_.size());
  for (int i = 0; i < leaves_.size(); ++i) costs[i] = leaves_[i].cost;
  costs.set_size(leaves_.size());
}

void TrackForest::expand_block(const IndexedScan& scan, int begin, int end) {
  int lanes = 0;
  for (int i = begin; i < end; ++i) {
    if (leaves_[i].misses != kEnded) load(leaves_[i], lanes++);
  }
  predict_(lane_model_, scan.buckets_per_km, scan.last_bucket, lanes_, lanes);
  int lane = 0;
  for (int i = begin; i < end; ++i) {
    if (leaves_[i].misses == kEnded) {
      append(leaves_[i], {i, kNoPlot});  // a column until the scan that ended it is fixed
    } else {
      expand(scan, i, lane++);
    }
  }
}

void TrackForest::load(const Leaf& leaf, int lane) {
  const int last = newest_ - 1 - leaf.misses;  // the scan of its last plot
  const AxisNoise& noise = noise_after_[leaf.misses];
  lanes_.dt[lane] = (leaf.misses + 1) * world_.scan_period_s;
  lanes_.noise_pp[lane] = noise.pp;
  lanes_.noise_pv[lane] = noise.pv;
  lanes_.noise_vv[lane] = noise.vv;
  lanes_.put(lane, state_after_last_plot(leaf, last));
}

LaneState TrackForest::state_after_last_plot(const Leaf& leaf, int last_scan) const {
  if (leaf.plots >= 3) return posteriors(last_scan)[leaf.source];
  if (leaf.plots == 2) return two_plots(leaf, last_scan);
  return newborn(scans_[scan_index(last_scan)].cartesian[static_cast<std::size_t>(leaf.source)]);
}

/// newborn_state of the filter, from the plot's Cartesian numbers.
LaneState TrackForest::newborn(const CartesianPlot& plot) const {
  return {
      {plot.x, 0.0, plot.y, 0.0},
      {plot.xx, 0.0, plot.xy, 0.0, velocity_variance_, 0.0, 0.0, plot.yy, 0.0, velocity_variance_}};
}

/// two_plot_state of the filter: in closed form where the model differences the two plots.
LaneState TrackForest::two_plots(const Leaf& leaf, int last_scan) const {
  const IndexedScan& first_scan = scans_[scan_index(leaf.birth_scan)];
  const IndexedScan& second_scan = scans_[scan_index(last_scan)];
  const auto i = static_cast<std::size_t>(leaf.first_plot);
  const auto j = static_cast<std::size_t>(leaf.source);
  const int scans = last_scan - leaf.birth_scan;
  if (model_.second_plot == SecondPlot::kTwoPoint) {
    const CartesianPlot& a = first_scan.cartesian[i];
    const CartesianPlot& b = second_scan.cartesian[j];
    const double per_s = 1.0 / (scans * world_.scan_period_s);
    const double per_s2 = per_s * per_s;
    const double noise = pair_noise_[static_cast<std::size_t>(scans)];
    return {{b.x, (b.x - a.x) * per_s, b.y, (b.y - a.y) * per_s},
            {b.xx, b.xx * per_s, b.xy, b.xy * per_s, (a.xx + b.xx) * per_s2 + noise, b.xy * per_s,
             (a.xy + b.xy) * per_s2, b.yy, b.yy * per_s, (a.yy + b.yy) * per_s2 + noise}};
  }
  const Gaussian state =
      two_plot_state(world_, model_, {first_scan.range[i], first_scan.bearing[i]},
                     {second_scan.range[j], second_scan.bearing[j]}, scans);
  LaneState packed{};
  for (int row = 0, entry = 0; row < 4; ++row) {
    packed.x[row] = state.mean(row);
    for (int column = row; column < 4; ++column) {
      packed.p[entry++] = state.covariance(row, column);
    }
  }
  return packed;
}

/// Children of one live leaf. Each candidate is written before its distance is looked at, and the
/// next one overwrites it if it lies outside the gate (14): no branch to mispredict.
void TrackForest::expand(const IndexedScan& scan, int parent, int lane) {
  const Leaf leaf = leaves_[parent];
  Buffer<Node>& nodes = layer(newest_).nodes;
  const int begin = scan.first_in(lanes_.first_bucket[lane]);
  const int end = scan.first_in(lanes_.end_bucket[lane]);
  const int first_child = next_.size();
  next_.make_room(end - begin + 1);
  nodes.make_room(end - begin + 1);

  Leaf child = leaf;
  child.plots = static_cast<std::uint8_t>(std::min(leaf.plots + 1, 3));
  child.misses = 0;
  const double cost = leaf.cost + lanes_.cost[lane];
  const double i_rr = lanes_.inverse_rr[lane];
  const double i_rb = lanes_.inverse_rb[lane];
  const double i_bb = lanes_.inverse_bb[lane];
  int size = first_child;
  for (int j = begin; j < end; ++j) {
    const auto at = static_cast<std::size_t>(j);
    const double dr = scan.range[at] - lanes_.range[lane];
    const double db = bearing_residual(scan.bearing[at], lanes_.bearing[lane]);
    const double d2 = dr * (i_rr * dr + 2.0 * i_rb * db) + i_bb * db * db;
    child.cost = cost + (scan.log_density[at] + 0.5 * d2);
    child.source = j;
    next_[size] = child;
    nodes[size] = {parent, j};
    size += static_cast<int>(d2 <= model_.gate);
  }
  next_.set_size(size);
  nodes.set_size(size);
  hypotheses_ += size - first_child + 1;
  if (leaf.plots >= 2) store_posteriors(scan, first_child, lane);
  append_miss(leaf, parent);
}

/// From the third plot on a hypothesis has a state of its own.
void TrackForest::store_posteriors(const IndexedScan& scan, int first_child, int lane) {
  Buffer<LaneState>& states = posteriors(newest_);
  const int children = next_.size() - first_child;
  states.make_room(children);
  for (int c = 0; c < children; ++c) {
    Leaf& child = next_[first_child + c];
    const auto at = static_cast<std::size_t>(child.source);
    const double dr = scan.range[at] - lanes_.range[lane];
    const double db = bearing_residual(scan.bearing[at], lanes_.bearing[lane]);
    child.source = states.size();
    LaneState& state = states[child.source];
    for (int i = 0; i < 4; ++i) {
      state.x[i] =
          lanes_.x[i][lane] + lanes_.gain_range[i][lane] * dr + lanes_.gain_bearing[i][lane] * db;
    }
    for (int i = 0; i < 10; ++i) state.p[i] = lanes_.updated[i][lane];
    states.set_size(child.source + 1);
  }
}

void TrackForest::append_miss(const Leaf& leaf, int parent) {
  Leaf child = leaf;
  child.cost += terms_.miss;
  child.misses = static_cast<std::uint8_t>(leaf.misses + 1);
  if (child.misses > model_.max_misses) {
    child.cost -= terms_.ended_discount;
    child.misses = kEnded;
    child.source = newest_;
    if (!is_column(child)) return;  // it will never gain anything again
  }
  append(child, {parent, kNoPlot});
}

void TrackForest::append(const Leaf& leaf, const Node& node) {
  next_.push_back(leaf);
  layer(newest_).nodes.push_back(node);
}

void TrackForest::append_births(const IndexedScan& scan) {
  layer(newest_).births_begin = next_.size();
  for (int j = 0; j < scan.size(); ++j) {
    append({terms_.birth, j, j, static_cast<std::int16_t>(newest_), 1, 0}, {kNoParent, j});
  }
  hypotheses_ += scan.size();
}

}  // namespace mda
