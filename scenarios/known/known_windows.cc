#include "scenarios/known/known_windows.h"

#include <stdexcept>
#include <utility>

#include "scenarios/hypotheses/track_forest.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace

KnownTrackWindows::KnownTrackWindows(const ScenarioSpec& spec, std::uint64_t seed, int replicate,
                                     int window_k)
    : world_(spec.world),
      scene_(simulate_known(spec, seed, replicate)),
      steps_(spec, scene_.clutter_box),
      window_k_(window_k),
      base_(scene_.initial) {
  const double detection_probability = spec.world.detection_probability;
  if (window_k < 1) throw std::invalid_argument("a window has one scan at least");
  if (!(detection_probability > 0.0 && detection_probability < 1.0)) {
    throw std::invalid_argument("the detection probability must be inside (0, 1)");
  }
}

bool KnownTrackWindows::next() {
  if (newest_ - fixed_ == window_k_) throw std::logic_error("next() before advance()");
  if (newest_ == static_cast<int>(scene_.scans.size())) return false;
  ++newest_;
  const std::span<const KnownScan> scans(scene_.scans);
  costs_ = std::make_shared<const TrackCosts>(
      world_, steps_, base_, scans.subspan(index(fixed_), index(newest_ - fixed_)));
  make_window();
  return true;
}

void KnownTrackWindows::make_window() {
  auto views = std::make_shared<Views>();
  views->tree = grower_.grow(*costs_);
  views->tuple_cost = [costs = costs_](const Tuple& tuple) { return costs->cost(tuple); };
  builder_.clear();
  add_rows();
  add_columns(views->tree);
  window_.problem = builder_.build();
  window_.problem.attach(std::move(views));
  window_.ungated_columns = tracks();
  for (int k = 1; k <= costs_->scans(); ++k) {
    window_.ungated_columns *= costs_->first_row(k + 1) - costs_->first_row(k) + 1;
  }
}

void KnownTrackWindows::add_rows() {
  for (int track = 0; track < tracks(); ++track) builder_.add_row(0, RowUse::kExactlyOnce);
  for (int k = 1; k <= costs_->scans(); ++k) {
    for (int row = costs_->first_row(k); row < costs_->first_row(k + 1); ++row) {
      builder_.add_row(k, RowUse::kAtMostOnce);
    }
  }
  builder_.set_dimensions(costs_->scans() + 1);
}

void KnownTrackWindows::add_columns(HypothesisTree& tree) {
  window_.leaf_of_column.clear();
  std::vector<int> rows;
  for (int leaf = tree.layer_begin[index(tree.scans())]; leaf < tree.nodes(); ++leaf) {
    rows.clear();
    for (int node = leaf; node != kNoNode; node = tree.parent[index(node)]) {
      if (tree.row[index(node)] != kNoRow) rows.push_back(tree.row[index(node)]);
    }
    tree.column[index(leaf)] = builder_.add_column(tree.cost[index(leaf)], rows);
    window_.leaf_of_column.push_back(leaf);
  }
}

void KnownTrackWindows::check(std::span<const Tuple> tuples) const {
  std::vector<bool> seen(index(tracks()), false);
  bool fits = costs_ && static_cast<int>(tuples.size()) == tracks();
  for (const Tuple& tuple : tuples) {
    fits = fits && tuple.track >= 0 && tuple.track < tracks() && !seen[index(tuple.track)] &&
           static_cast<int>(tuple.rows.size()) == costs_->scans();
    if (!fits) break;
    seen[index(tuple.track)] = true;
    for (int k = 1; k <= costs_->scans(); ++k) {
      const int row = tuple.rows[index(k - 1)];
      fits = fits &&
             (row == kNoRow || (row >= costs_->first_row(k) && row < costs_->first_row(k + 1)));
    }
  }
  if (!fits) throw std::invalid_argument("not one sequence of this window for every track");
}

void KnownTrackWindows::advance(std::span<const Tuple> tuples) {
  check(tuples);
  if (newest_ - fixed_ < window_k_) return;
  for (const Tuple& tuple : tuples) base_[index(tuple.track)] = costs_->state(tuple, 1);
  ++fixed_;
}

std::vector<Tuple> KnownTrackWindows::sequences_of(std::span<const int> columns) const {
  const HypothesisTree& tree = window_.problem.views()->tree;
  std::vector<Tuple> tuples;
  for (const int column : columns) {
    const int leaf = window_.leaf_of_column[index(column)];
    tuples.push_back({tree.track[index(leaf)], std::vector<int>(index(tree.scans()))});
    Tuple& tuple = tuples.back();
    int node = leaf;
    for (int k = tree.scans(); k > 0; --k, node = tree.parent[index(node)]) {
      tuple.rows[index(k - 1)] = tree.row[index(node)];
    }
  }
  return tuples;
}

std::vector<TargetState> KnownTrackWindows::estimates(std::span<const Tuple> tuples) const {
  check(tuples);
  std::vector<TargetState> states(index(tracks()));
  for (const Tuple& tuple : tuples) {
    states[index(tuple.track)] = state_of(costs_->state(tuple, costs_->scans()));
  }
  return states;
}

std::vector<TargetState> KnownTrackWindows::lagged_estimates() const {
  std::vector<TargetState> states;
  for (const Gaussian& base : base_) states.push_back(state_of(base));
  return states;
}

std::vector<int> KnownTrackWindows::decisions(std::span<const Tuple> tuples, int k) const {
  check(tuples);
  std::vector<int> plots(index(tracks()), kNoPlot);
  for (const Tuple& tuple : tuples) {
    const int row = tuple.rows.at(index(k - 1));
    if (row != kNoRow) plots[index(tuple.track)] = row - costs_->first_row(k);
  }
  return plots;
}

}  // namespace mda
