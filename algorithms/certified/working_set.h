// The columns of each tree that are nearly its best, and what they say about the price of a row.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/certified/links.h"

namespace mda {

/// Columns come and stay. Those of a tree stand side by side, and every link has a mask of the ones
/// that use its row, 64 to a word: a price is moved, and what it is worth to the tree is found, by
/// a pass over a few words and reduced costs.
class WorkingSet {
 public:
  /// Empty. O(columns + sum over trees of links * columns / 64).
  void start(const Packing& packing, const Links& links);

  /// Takes in the columns of `tree` whose reduced cost is `most` or less; true if there are new
  /// ones. O(columns of the tree + entries of the new ones).
  bool widen(int tree, std::span<const Steps> reduced, Steps most);

  /// The links of a row that a column of the set uses, in no order.
  [[nodiscard]] std::span<const int> links_of(int row) const {
    const auto r = static_cast<std::size_t>(row);
    return {by_row_.data() + links_->row_begin[r], static_cast<std::size_t>(used_of_[r])};
  }

  /// By how much more the price of the row of a link that is used may rise until the tree gives it
  /// up: what its best column without the row, or no column at all, costs more than its best with
  /// it. Negative where it has given it up. O(columns of the tree in the set).
  [[nodiscard]] Steps worth(int link);
  /// The price of the link's row changes by `change`. O(columns of the link).
  void move(int link, Steps change);

  /// The tree's columns in the set, and their reduced costs.
  [[nodiscard]] std::span<const int> columns_of(int tree) const {
    return {column_.data() + first_of(tree), size_of(tree)};
  }
  [[nodiscard]] std::span<const Steps> reduced_of(int tree) const {
    return {reduced_.data() + first_of(tree), size_of(tree)};
  }

 private:
  [[nodiscard]] std::size_t first_of(int tree) const {
    return static_cast<std::size_t>(packing_->tree_begin[static_cast<std::size_t>(tree)]);
  }
  [[nodiscard]] std::size_t size_of(int tree) const {
    return static_cast<std::size_t>(size_[static_cast<std::size_t>(tree)]);
  }
  void add(int tree, int column, Steps reduced);
  void find_best(int tree);
  [[nodiscard]] const std::uint64_t* mask(int link) const;

  const Packing* packing_ = nullptr;
  const Links* links_ = nullptr;
  std::vector<char> is_in_;  // per column
  // Per tree from tree_begin[t], size_[t] of them.
  std::vector<int> column_;
  std::vector<Steps> reduced_;
  std::vector<int> size_;
  std::vector<int> best_;                // per tree, the place of its cheapest, or unknown
  std::vector<std::size_t> mask_begin_;  // per link
  std::vector<std::uint64_t> masks_;
  std::vector<char> is_used_;  // per link
  std::vector<int> by_row_;    // per row from row_begin[r] of the links, used_of_[r] links
  std::vector<int> used_of_;
};

}  // namespace mda
