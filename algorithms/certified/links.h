// Which trees of a packing use which rows, and what their columns have in common.
#pragma once

#include <span>
#include <vector>

#include "algorithms/certified/packing.h"

namespace mda {

/// A link is a tree and a row that one or more of its columns use. A price concerns a tree through
/// its link alone, and a tree has far fewer links than entries.
///
/// A column is a path of nodes, each of which adds a link to the path of its parent. It shares the
/// nodes of the rows with which it and the column before it both begin: leaves of a hypothesis tree
/// come in an order in which most of their rows are shared.
struct Links {
  std::vector<int> tree_begin;  ///< links of tree t: from tree_begin[t]
  std::vector<int> tree;        ///< per link
  std::vector<int> row;         ///< per link
  std::vector<int> row_begin;   ///< links of row r: from row_begin[r] of by_row
  std::vector<int> by_row;      ///< links; those of a row in the order of their trees

  struct Node {
    int parent;
    int link;
  };
  static constexpr int kTop = 0;    ///< the node of an empty path
  std::vector<Node> node;           ///< parents first
  std::vector<int> node_begin;      ///< nodes of tree t: from node_begin[t]
  std::vector<int> node_of_column;  ///< the last of its path

  [[nodiscard]] int count() const noexcept { return static_cast<int>(row.size()); }
  [[nodiscard]] int nodes() const noexcept { return static_cast<int>(node.size()); }
  [[nodiscard]] std::span<const int> of_row(int r) const {
    const auto first = static_cast<std::size_t>(row_begin[static_cast<std::size_t>(r)]);
    const auto last = static_cast<std::size_t>(row_begin[static_cast<std::size_t>(r) + 1]);
    return {by_row.data() + first, last - first};
  }
};

/// Finds the links of one packing after the other. Keeps buffers between calls, nothing else.
class LinkFinder {
 public:
  /// O(nonzeros + rows).
  void find(const Packing& packing, Links& links);

 private:
  void add_tree(const Packing& packing, int tree, Links& links);
  int link_of(int tree, int row, int first_link, Links& links);
  void sort_by_row(Links& links);

  std::vector<int> last_link_;  // per row
  std::vector<int> path_;       // nodes of the column before, from the top
  std::vector<int> next_;       // per row, the place of its next link
};

}  // namespace mda
