// Which trees of a packing use which rows.
#pragma once

#include <span>
#include <vector>

#include "algorithms/certified/packing.h"

namespace mda {

/// A link is a tree and a row that one or more of its columns use. A price concerns a tree through
/// its link alone, and a tree has far fewer links than entries.
struct Links {
  std::vector<int> tree_begin = {0};  ///< links of tree t: from tree_begin[t]
  std::vector<int> tree;              ///< per link
  std::vector<int> row;               ///< per link
  std::vector<int> of_entry;          ///< per entry of Packing::row, its link
  std::vector<int> row_begin;         ///< links of row r: from row_begin[r] of by_row
  std::vector<int> by_row;            ///< links; those of a row in the order of their trees

  [[nodiscard]] int count() const noexcept { return static_cast<int>(row.size()); }
  [[nodiscard]] std::span<const int> of_row(int r) const {
    const auto first = static_cast<std::size_t>(row_begin[static_cast<std::size_t>(r)]);
    const auto last = static_cast<std::size_t>(row_begin[static_cast<std::size_t>(r) + 1]);
    return {by_row.data() + first, last - first};
  }
};

/// O(nonzeros + rows).
[[nodiscard]] Links links_of(const Packing& packing);

}  // namespace mda
