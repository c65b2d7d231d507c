#include "scenarios/hypotheses/tree_view.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Layer k of the view is scan first_scan - 1 + k of the forest; layer 0 holds the fixed tracks.
class TreeView {
 public:
  TreeView(const TrackForest& forest, const WindowInstance& window)
      : forest_(forest), window_(window) {}

  HypothesisTree make() {
    mark_columns();
    int first_row = forest_.tracks();
    number_.clear();
    tree_.layer_begin.push_back(0);
    if (forest_.fixed_scan() > 0) append_layer(0, 0);
    for (int k = 1; k <= scans(); ++k) {
      tree_.layer_begin.push_back(tree_.nodes());
      append_layer(k, first_row);
      first_row += forest_.plots(forest_.fixed_scan() + k);
    }
    tree_.layer_begin.push_back(tree_.nodes());
    index_children(tree_);
    return std::move(tree_);
  }

 private:
  [[nodiscard]] int scans() const { return forest_.newest_scan() - forest_.fixed_scan(); }
  [[nodiscard]] std::span<const Node> nodes(int layer) const {
    return forest_.nodes(forest_.fixed_scan() + layer);
  }

  /// column_[layer][node]: of a leaf its column, of a node above any column that it leads to.
  void mark_columns() {
    column_.resize(index(scans()) + 1);
    for (int k = forest_.fixed_scan() > 0 ? 0 : 1; k <= scans(); ++k) {
      column_[index(k)].assign(nodes(k).size(), kNoColumn);
    }
    for (std::size_t j = 0; j < window_.leaf_of_column.size(); ++j) {
      const int leaf = window_.leaf_of_column[j];
      if (leaf >= 0) column_.back()[index(leaf)] = static_cast<int>(j);
    }
    for (int k = scans(); k > 0; --k) {
      const auto here = nodes(k);
      for (std::size_t n = 0; n < here.size(); ++n) {
        const int parent = here[n].parent;
        const int column = column_[index(k)][n];
        if (column == kNoColumn || parent == kNoParent) continue;
        column_[index(k) - 1][index(parent)] = column;
      }
    }
  }

  void append_layer(int k, int first_row) {
    const auto here = nodes(k);
    std::vector<int> number(here.size(), kNoNode);
    for (std::size_t n = 0; n < here.size(); ++n) {
      const int column = column_[index(k)][n];
      if (column == kNoColumn) continue;
      number[n] = tree_.nodes();
      const int old_parent = k == 0 ? kNoParent : here[n].parent;
      const int parent = old_parent == kNoParent ? kNoNode : number_[index(old_parent)];
      const int own_row = here[n].plot == kNoPlot ? kNoRow : first_row + here[n].plot;
      const int row = k == 0 ? static_cast<int>(n) : own_row;
      append_node(k, static_cast<int>(n), parent, row, column);
    }
    number_ = std::move(number);
  }

  void append_node(int k, int node, int parent, int row, int column) {
    const bool is_leaf = k == scans();
    const double cost =
        is_leaf ? window_.problem.cost(column) : forest_.node_cost(forest_.fixed_scan() + k, node);
    const double before = parent == kNoNode ? 0.0 : tree_.cost[index(parent)];
    tree_.track.push_back(k == 0 ? row : parent == kNoNode ? kNoRow : tree_.track[index(parent)]);
    tree_.parent.push_back(parent);
    tree_.row.push_back(row);
    tree_.step.push_back(cost - before);
    tree_.cost.push_back(cost);
    tree_.column.push_back(is_leaf ? column : kNoColumn);
  }

  const TrackForest& forest_;
  const WindowInstance& window_;
  HypothesisTree tree_;
  std::vector<std::vector<int>> column_;
  std::vector<int> number_;  ///< in the view, of the nodes of the layer before
};

}  // namespace

HypothesisTree tree_of(const TrackForest& forest, const WindowInstance& window) {
  return TreeView(forest, window).make();
}

}  // namespace mda
