#include "scenarios/cartesian/position_windows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "scenarios/cartesian/trajectories.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// [target].
std::vector<MotionModel> models_of(const World& world, const PositionTargets& targets) {
  std::vector<MotionModel> models;
  for (const int number : target_numbers(targets.scene)) {
    const bool fading = targets.manoeuvres == ManoeuvreModel::kSinger && manoeuvres(number);
    models.push_back(fading ? singer(world.scan_period_s, targets.singer_acceleration_sigma_km_s2,
                                     targets.singer_time_s)
                            : constant_velocity(world));
  }
  return models;
}

/// Squared distance from the line through `end` along `step`, or from `end` if there is no step.
double line_distance(const Eigen::Vector2d& plot, const Eigen::Vector2d& end,
                     const Eigen::Vector2d& step) {
  const Eigen::Vector2d off = plot - end;
  const double length = step.squaredNorm();
  if (!(length > 0.0)) return off.squaredNorm();
  const double cross = off.x() * step.y() - off.y() * step.x();
  return cross * cross / length;
}

Eigen::Vector2d position_of(const MotionEstimate& estimate) {
  const TargetState state = state_of(estimate);
  return {state.x, state.y};
}

/// -ln(P_D N / lambda).
double plot_cost(const PairView& pairs, std::size_t pair) {
  return std::log(pairs.clutter_density / pairs.detection_probability) - pairs.log_likelihood[pair];
}

/// -ln(1 - P_D P_G).
double miss_cost(const PairView& pairs) {
  return -std::log(1.0 - pairs.detection_probability * pairs.gate_probability);
}

/// What a track's choice in the window costs, in the gate or not.
double tuple_cost(const PairView& pairs, const Tuple& tuple) {
  const int row = tuple.rows.front();
  if (row == kNoRow) return miss_cost(pairs);
  return plot_cost(pairs, pairs.at(tuple.track, row - pairs.tracks()));
}

}  // namespace

PositionWindows::PositionWindows(const ScenarioSpec& spec, std::uint64_t seed, int replicate)
    : world_(spec.world),
      gate_(spec.model.gate),
      scene_(simulate_positions(spec, seed, replicate)) {
  if (!(world_.detection_probability > 0.0 && world_.detection_probability < 1.0)) {
    throw std::invalid_argument("the detection probability must be inside (0, 1)");
  }
  targets_ = *spec.position_targets;
  models_ = models_of(world_, targets_);
  for (std::size_t i = 0; i < models_.size(); ++i) {
    const auto& [before, now] = scene_.looks[i];
    estimates_.push_back(
        two_plot_estimate(models_[i], targets_.plot_sigma_km, world_.scan_period_s, before, now));
  }
  predicted_ = estimates_;
  expected_.resize(models_.size());
  dropped_.assign(models_.size(), false);
}

bool PositionWindows::next() {
  if (!advanced_) throw std::logic_error("next() before advance()");
  if (newest_ == std::ssize(scene_.scans)) return false;
  ++newest_;
  advanced_ = false;
  for (std::size_t i = 0; i < models_.size(); ++i) {
    predicted_[i] = predict(models_[i], estimates_[i]);
    if (!dropped_[i]) expected_[i] = innovation(targets_.plot_sigma_km, predicted_[i]);
  }
  make_window();
  return true;
}

void PositionWindows::make_window() {
  target_of_row_.clear();
  for (int target = 0; target < targets(); ++target) {
    if (!is_dropped(target)) target_of_row_.push_back(target);
  }
  auto views = std::make_shared<Views>();
  builder_.clear();
  PairView pairs = pairs_without_columns();
  for (int track = 0; track < pairs.tracks(); ++track) builder_.add_row(0, RowUse::kExactlyOnce);
  for (int plot = 0; plot < pairs.plots(); ++plot) builder_.add_row(1, RowUse::kAtMostOnce);
  builder_.set_dimensions(2);
  add_columns(views->tree, pairs);
  window_.problem = builder_.build();
  window_.ungated_columns = static_cast<double>(pairs.tracks()) * (pairs.plots() + 1);
  views->tuple_cost = [pairs](const Tuple& tuple) { return tuple_cost(pairs, tuple); };
  views->pairs = std::move(pairs);
  window_.problem.attach(std::move(views));
}

double PositionWindows::clutter_density() const {
  if (newest_ <= targets_.quiet_scans) return kLeastClutterPerKm2;
  return std::max(targets_.clutter_per_km2, kLeastClutterPerKm2);
}

PairView PositionWindows::pairs_without_columns() const {
  PairView pairs;
  pairs.gate = gate_;
  pairs.detection_probability = world_.detection_probability;
  pairs.gate_probability = 1.0 - std::exp(-0.5 * gate_);
  pairs.clutter_density = clutter_density();
  const auto tracks = static_cast<int>(target_of_row_.size());
  for (int track = 0; track < tracks; ++track) pairs.track_row.push_back(track);
  for (int plot = 0; plot < std::ssize(scan().plots); ++plot) {
    pairs.plot_row.push_back(tracks + plot);
  }
  for (const int target : target_of_row_) {
    const PositionInnovation& expected = expected_[index(target)];
    const Eigen::Vector2d step = expected.plot - position_of(estimates_[index(target)]);
    for (const PositionPlot& plot : scan().plots) {
      const double distance = expected.distance(plot.position);
      pairs.distance.push_back(distance);
      pairs.line_distance.push_back(line_distance(plot.position, expected.plot, step));
      pairs.log_likelihood.push_back(expected.log_peak - 0.5 * distance);
    }
  }
  pairs.column.assign(pairs.distance.size(), kNoColumn);
  return pairs;
}

void PositionWindows::add_columns(HypothesisTree& tree, PairView& pairs) {
  window_.leaf_of_column.clear();
  tree.layer_begin = {0, pairs.tracks()};
  for (int track = 0; track < pairs.tracks(); ++track) {
    tree.parent.push_back(kNoNode);
    tree.row.push_back(track);
  }
  tree.track = tree.row;
  tree.step.assign(index(pairs.tracks()), 0.0);
  tree.cost = tree.step;
  tree.column.assign(index(pairs.tracks()), kNoColumn);
  for (int track = 0; track < pairs.tracks(); ++track) {
    for (int plot = 0; plot < pairs.plots(); ++plot) {
      const std::size_t pair = pairs.at(track, plot);
      if (pairs.distance[pair] > gate_) continue;
      pairs.column[pair] =
          add_column(tree, track, pairs.plot_row[index(plot)], plot_cost(pairs, pair));
    }
    pairs.miss_column.push_back(add_column(tree, track, kNoRow, miss_cost(pairs)));
  }
  tree.layer_begin.push_back(tree.nodes());
  index_children(tree);
}

int PositionWindows::add_column(HypothesisTree& tree, int track, int row, double cost) {
  const std::array<int, 2> rows = {track, row};
  const int column = builder_.add_column(cost, std::span(rows).first(row == kNoRow ? 1 : 2));
  window_.leaf_of_column.push_back(tree.nodes());
  tree.parent.push_back(track);
  tree.row.push_back(row);
  tree.track.push_back(track);
  tree.step.push_back(cost);
  tree.cost.push_back(cost);
  tree.column.push_back(column);
  return column;
}

std::vector<Belief> PositionWindows::beliefs_of(std::span<const double> x) const {
  const AssociationProblem& problem = window_.problem;
  const auto tracks = static_cast<int>(target_of_row_.size());
  std::vector<Belief> beliefs(index(targets()));
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    if (rows.size() < 2 || !(x[index(j)] > 0.0)) continue;
    beliefs[index(target_of_row(rows[0]))].items.push_back({rows[1] - tracks, x[index(j)]});
  }
  return beliefs;
}

std::vector<Belief> PositionWindows::true_beliefs() const {
  std::vector<Belief> beliefs(index(targets()));
  const auto& plots = scan().plots;
  for (int plot = 0; plot < std::ssize(plots); ++plot) {
    const int source = plots[index(plot)].source;
    if (source != kFalseAlarm) beliefs[index(source)].items.push_back({plot, 1.0});
  }
  return beliefs;
}

void PositionWindows::advance(std::span<const Belief> beliefs) {
  if (advanced_) throw std::logic_error("advance() before next()");
  if (std::ssize(beliefs) != targets()) throw std::invalid_argument("not one belief per target");
  const auto& plots = scan().plots;
  std::vector<WeightedPlot> weighted;
  for (std::size_t i = 0; i < beliefs.size(); ++i) {
    weighted.clear();
    for (const auto& [plot, probability] : beliefs[i].items) {
      if (plot < 0 || plot >= std::ssize(plots) || !(probability >= 0.0) ||
          !std::isfinite(probability)) {
        throw std::invalid_argument("a belief in no plot, or without a probability");
      }
      weighted.push_back({plots[index(plot)].position, probability});
    }
    estimates_[i] = dropped_[i]
                        ? predicted_[i]
                        : update(predicted_[i], expected_[i], targets_.plot_sigma_km, weighted);
  }
  advanced_ = true;
  drop_lost_tracks();
}

void PositionWindows::drop_lost_tracks() {
  for (std::size_t i = 0; i < estimates_.size(); ++i) {
    const MotionEstimate& estimate = estimates_[i];
    const TargetState& truth = scan().truth[i];
    const Eigen::Vector2d off = position_of(estimate) - Eigen::Vector2d(truth.x, truth.y);
    const double variance = std::max(estimate.covariance(0, 0), estimate.covariance(3, 3));
    if (off.norm() > kDroppedKm || variance > kDroppedVarianceKm2) dropped_[i] = true;
  }
}

}  // namespace mda
