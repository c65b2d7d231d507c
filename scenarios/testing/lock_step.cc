#include "scenarios/testing/lock_step.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "scenarios/testing/choices.h"

namespace mda::testing {
namespace {

constexpr double kToleranceNats = 1e-9;

std::string text_of(const History& history) {
  std::ostringstream text;
  for (const PlotOfScan& plot : history) text << ' ' << plot.scan << ':' << plot.plot;
  return text.str();
}

template <typename A, typename B>
std::string differs(const std::string& what, const A& actual, const B& expected) {
  std::ostringstream text;
  text.precision(17);
  text << what << ": " << actual << ", expected " << expected;
  return text.str();
}

}  // namespace

LockStep::LockStep(const ScenarioSpec& spec, int window_k)
    : reference_(spec.world, spec.model, window_k) {
  forest_.reset(spec.world, spec.model, window_k);
}

std::string LockStep::grow(const Scan& scan) {
  forest_.grow(scan);
  reference_.grow(scan);
  window_ = extractor_.extract(forest_);
  expected_ = reference_.columns();
  count();
  const auto leaves = forest_.leaves();
  const auto live = std::count_if(leaves.begin(), leaves.end(),
                                  [](const Leaf& leaf) { return leaf.misses != kEnded; });
  if (live != reference_.live()) return differs("live hypotheses", live, reference_.live());
  return compare_columns();
}

std::string LockStep::compare_columns() {
  std::size_t tracks = 0;
  for (int column = 0; column < window_.problem.columns(); ++column) {
    const int leaf = window_.leaf_of_column[static_cast<std::size_t>(column)];
    if (leaf < 0) continue;
    ++tracks;
    const History history = histories_.of_column(forest_, window_.problem, column);
    if (history != histories_.of_leaf(forest_, leaf)) {
      return differs("rows of a column", text_of(history),
                     text_of(histories_.of_leaf(forest_, leaf)));
    }
    const auto found = expected_.find(history);
    if (found == expected_.end()) return "a column too many:" + text_of(history);
    const double difference = std::abs(window_.problem.cost(column) - found->second);
    if (!(difference <= kToleranceNats)) {
      return differs("cost of" + text_of(history), window_.problem.cost(column), found->second);
    }
  }
  return tracks == expected_.size() ? "" : differs("columns", tracks, expected_.size());
}

void LockStep::count() {
  for (const int leaf : window_.leaf_of_column) {
    if (leaf < 0) continue;
    const Leaf& end = forest_.leaves()[static_cast<std::size_t>(leaf)];
    ++tally_.columns;
    tally_.ended_columns += end.misses == kEnded ? 1 : 0;
    tally_.long_columns += end.plots > 2 ? 1 : 0;
  }
  for (const Leaf& leaf : forest_.leaves()) {
    const bool pair = leaf.misses != kEnded && leaf.plots == 2;
    tally_.orphaned_pairs += pair && leaf.birth_scan < forest_.fixed_scan() ? 1 : 0;
  }
}

std::string LockStep::decide(std::span<const int> columns) {
  std::vector<History> chosen;
  double chosen_nats = 0.0;
  const std::vector<int> leaves = leaves_of(window_, columns);
  for (const int leaf : leaves) {
    chosen.push_back(histories_.of_leaf(forest_, leaf));
    chosen_nats += forest_.column_cost(forest_.leaves()[static_cast<std::size_t>(leaf)]);
  }
  double total_nats = window_.retired_nats + chosen_nats;
  for (const auto& [history, cost] : reference_.retired()) total_nats -= cost;
  for (const History& history : chosen) total_nats -= expected_.at(history);
  if (std::abs(total_nats) > kToleranceNats) return differs("total cost less", total_nats, 0.0);

  histories_.before_decision(forest_, leaves);
  forest_.decide(leaves);
  reference_.decide(chosen);
  std::vector<History> tracks = histories_.tracks();
  std::sort(tracks.begin(), tracks.end());
  tally_.fixed_tracks += forest_.tracks();
  if (forest_.fixed_scan() != reference_.fixed_scan()) {
    return differs("fixed scan", forest_.fixed_scan(), reference_.fixed_scan());
  }
  if (tracks != reference_.tracks() || forest_.tracks() != static_cast<int>(tracks.size())) {
    return differs("fixed tracks", forest_.tracks(), reference_.tracks().size());
  }
  return "";
}

}  // namespace mda::testing
