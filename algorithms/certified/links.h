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
  std::vector<int> tree_begin = {0};  ///< links of tree t: from tree_begin[t]
  std::vector<int> tree;              ///< per link
  std::vector<int> row;               ///< per link
  std::vector<int> row_begin;         ///< links of row r: from row_begin[r] of by_row
  std::vector<int> by_row;            ///< links; those of a row in the order of their trees

  static constexpr int kTop = 0;      ///< the node of an empty path
  std::vector<int> node_begin = {1};  ///< nodes of tree t: from node_begin[t], parents first
  std::vector<int> parent = {kTop};   ///< per node
  std::vector<int> link = {-1};       ///< per node
  std::vector<int> node_of_column;    ///< the last of its path

  [[nodiscard]] int count() const noexcept { return static_cast<int>(row.size()); }
  [[nodiscard]] int nodes() const noexcept { return static_cast<int>(parent.size()); }
  [[nodiscard]] std::span<const int> of_row(int r) const {
    const auto first = static_cast<std::size_t>(row_begin[static_cast<std::size_t>(r)]);
    const auto last = static_cast<std::size_t>(row_begin[static_cast<std::size_t>(r) + 1]);
    return {by_row.data() + first, last - first};
  }
};

/// O(nonzeros + rows).
[[nodiscard]] Links links_of(const Packing& packing);

}  // namespace mda
