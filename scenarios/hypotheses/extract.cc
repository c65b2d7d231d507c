#include "scenarios/hypotheses/extract.h"

namespace mda {

WindowInstance WindowExtractor::extract(const TrackForest& forest) {
  builder_.clear();
  add_rows(forest);
  WindowInstance window;
  const auto leaves = forest.leaves();
  for (int leaf = 0; leaf < static_cast<int>(leaves.size()); ++leaf) {
    if (!forest.is_column(leaves[static_cast<std::size_t>(leaf)])) continue;
    add_column(forest, leaf);
    window.leaf_of_column.push_back(leaf);
  }
  if (forest.model().rows == RowRule::kEquality) {
    for (int row = 0; row < builder_.rows(); ++row) {
      builder_.add_column(0.0, {&row, 1});
      window.leaf_of_column.push_back(-1);
    }
  }
  window.problem = builder_.build();
  window.ungated_columns = forest.fixed_scan() > 0 ? forest.tracks() + 1.0 : 1.0;
  for (int scan = forest.fixed_scan() + 1; scan <= forest.newest_scan(); ++scan) {
    window.ungated_columns *= forest.plots(scan) + 1.0;
  }
  window.ungated_columns -= 1.0;  // the track without plots
  window.retired_nats = forest.retired_cost();
  return window;
}

void WindowExtractor::add_rows(const TrackForest& forest) {
  const RowUse use =
      forest.model().rows == RowRule::kEquality ? RowUse::kExactlyOnce : RowUse::kAtMostOnce;
  const int fixed = forest.fixed_scan();
  for (int track = 0; track < forest.tracks(); ++track) builder_.add_row(0, use);
  first_row_of_scan_.assign(1, 0);
  for (int scan = fixed + 1; scan <= forest.newest_scan(); ++scan) {
    first_row_of_scan_.push_back(builder_.rows());
    for (int plot = 0; plot < forest.plots(scan); ++plot) builder_.add_row(scan - fixed, use);
  }
  builder_.set_dimensions(forest.newest_scan() - fixed + (fixed > 0 ? 1 : 0));
}

/// Walks from the leaf up to its birth or to the fixed track that it continues.
void WindowExtractor::add_column(const TrackForest& forest, int leaf) {
  rows_.clear();
  int node = leaf;
  int scan = forest.newest_scan();
  for (; scan > forest.fixed_scan() && node != kNoParent; --scan) {
    const Node& here = forest.nodes(scan)[static_cast<std::size_t>(node)];
    if (here.plot != kNoPlot) {
      rows_.push_back(first_row_of_scan_[static_cast<std::size_t>(scan - forest.fixed_scan())] +
                      here.plot);
    }
    node = here.parent;
  }
  if (node != kNoParent) rows_.push_back(node);
  const double cost = forest.column_cost(forest.leaves()[static_cast<std::size_t>(leaf)]);
  builder_.add_column(cost, rows_);
}

}  // namespace mda
