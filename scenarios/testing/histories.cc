#include "scenarios/testing/histories.h"

#include <algorithm>
#include <map>

namespace mda::testing {
namespace {

const Node& node_at(const TrackForest& forest, int scan, int node) {
  return forest.nodes(scan)[static_cast<std::size_t>(node)];
}

/// The node of an older scan that a leaf descends from, or kNoParent.
int ancestor(const TrackForest& forest, int leaf, int scan) {
  int node = leaf;
  for (int s = forest.newest_scan(); s > scan && node != kNoParent; --s) {
    node = node_at(forest, s, node).parent;
  }
  return node;
}

}  // namespace

History Histories::of_leaf(const TrackForest& forest, int leaf) const {
  History history;
  int node = leaf;
  for (int scan = forest.newest_scan(); scan > forest.fixed_scan() && node != kNoParent; --scan) {
    const Node& here = node_at(forest, scan, node);
    if (here.plot != kNoPlot) history.push_back({scan, here.plot});
    node = here.parent;
  }
  std::reverse(history.begin(), history.end());
  if (node != kNoParent) {
    const History& track = tracks_.at(static_cast<std::size_t>(node));
    history.insert(history.begin(), track.begin(), track.end());
  }
  return history;
}

History Histories::of_column(const TrackForest& forest, const AssociationProblem& problem,
                             int column) const {
  History history;
  for (const int row : problem.rows_of(column)) {
    int plot = row - static_cast<int>(tracks_.size());
    if (plot < 0) {
      history = tracks_.at(static_cast<std::size_t>(row));
      continue;
    }
    int scan = forest.fixed_scan() + 1;
    for (; plot >= forest.plots(scan); ++scan) plot -= forest.plots(scan);
    history.push_back({scan, plot});
  }
  return history;
}

void Histories::before_decision(const TrackForest& forest, std::span<const int> chosen) {
  if (forest.newest_scan() <= forest.window_k()) return;
  const int fixed = forest.newest_scan() - forest.window_k() + 1;
  std::map<int, History> track_of_node;
  for (const int leaf : chosen) {
    const Leaf& end = forest.leaves()[static_cast<std::size_t>(leaf)];
    if (end.misses == kEnded && end.source <= fixed) continue;
    const int node = ancestor(forest, leaf, fixed);
    if (node != kNoParent) track_of_node[node] = up_to(of_leaf(forest, leaf), fixed);
  }
  tracks_.clear();
  for (const auto& [node, track] : track_of_node) tracks_.push_back(track);
}

}  // namespace mda::testing
