#include "algorithms/certified/parts.h"

#include <algorithm>
#include <numeric>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kNone = -1;

/// Sets of rows that are joined by columns.
class JoinedRows {
 public:
  explicit JoinedRows(int rows) : parent_(index(rows)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int root(int row) {
    while (parent_[index(row)] != row) {
      parent_[index(row)] = parent_[index(parent_[index(row)])];
      row = parent_[index(row)];
    }
    return row;
  }

  void join(int a, int b) { parent_[index(root(a))] = root(b); }

 private:
  std::vector<int> parent_;
};

class Splitter {
 public:
  Splitter(const Packing& packing, std::span<const Steps> prices, std::span<const char> alive)
      : packing_(packing),
        prices_(prices),
        alive_(alive),
        joined_(packing.rows()),
        is_used_(index(packing.rows()), 0),
        part_of_set_(index(packing.rows()), kNone),
        number_(index(packing.rows()), kNone) {
    for (int j = 0; j < packing.columns(); ++j) {
      if (alive[index(j)] == 0) continue;
      const auto rows = packing.rows_of(j);
      for (const int r : rows) {
        is_used_[index(r)] = 1;
        if (r != rows[0]) joined_.join(r, rows[0]);
      }
    }
  }

  /// Makes one part of the sets in which the choice loses nothing: neither reduced costs of its
  /// columns nor prices of rows that it leaves free.
  void settle(std::span<const Steps> reduced, std::span<const int> choice) {
    std::vector<char> is_covered(is_used_.size(), 0);
    std::vector<char> loses(is_used_.size(), 0);  // per set
    for (const int j : choice) {
      if (alive_[index(j)] == 0) continue;
      for (const int r : packing_.rows_of(j)) is_covered[index(r)] = 1;
      if (reduced[index(j)] != 0) loses[index(set_of_column(j))] = 1;
    }
    for (int r = 0; r < packing_.rows(); ++r) {
      const bool is_lost = is_covered[index(r)] == 0 && prices_[index(r)] != 0;
      if (is_used_[index(r)] != 0 && is_lost) loses[index(joined_.root(r))] = 1;
    }
    parts_.emplace_back().choice.emplace();
    for (int r = 0; r < packing_.rows(); ++r) {
      if (is_used_[index(r)] == 0) continue;
      const int set = joined_.root(r);
      if (loses[index(set)] == 0) part_of_set_[index(set)] = 0;
    }
    for (const int j : choice) {
      if (alive_[index(j)] == 0 || loses[index(set_of_column(j))] != 0) continue;
      parts_[0].choice->push_back(packing_.origin[index(j)]);
    }
  }

  std::vector<Part> split() {
    hand_out_rows();
    for (int t = 0; t < packing_.trees(); ++t) hand_out_tree(t);
    std::ranges::stable_sort(parts_, {}, [](const Part& part) { return part.packing.columns(); });
    return std::move(parts_);
  }

 private:
  int set_of_column(int column) { return joined_.root(packing_.rows_of(column)[0]); }

  void hand_out_rows() {
    for (int r = 0; r < packing_.rows(); ++r) {
      if (is_used_[index(r)] == 0) continue;
      int& p = part_of_set_[index(joined_.root(r))];
      if (p == kNone) {
        p = static_cast<int>(parts_.size());
        parts_.emplace_back();
      }
      Part& part = parts_[index(p)];
      number_[index(r)] = part.packing.rows();
      part.packing.row_origin.push_back(packing_.row_origin[index(r)]);
      part.prices.push_back(prices_[index(r)]);
      part.bound -= prices_[index(r)];
    }
  }

  void hand_out_tree(int tree) {
    const int root = packing_.root[index(tree)];
    if (is_used_[index(root)] == 0) return;
    Part& part = parts_[index(part_of_set_[index(joined_.root(root))])];
    if (part.choice) return;
    Packing& to = part.packing;
    const int before = to.columns();
    for (int j = packing_.tree_begin[index(tree)]; j < packing_.tree_begin[index(tree) + 1]; ++j) {
      if (alive_[index(j)] == 0) continue;
      for (const int r : packing_.rows_of(j)) to.row.push_back(number_[index(r)]);
      to.begin.push_back(static_cast<int>(to.row.size()));
      to.cost.push_back(packing_.cost[index(j)]);
      to.origin.push_back(packing_.origin[index(j)]);
    }
    if (to.columns() == before) return;
    to.root.push_back(number_[index(root)]);
    to.tree_begin.push_back(to.columns());
  }

  const Packing& packing_;
  std::span<const Steps> prices_;
  std::span<const char> alive_;
  JoinedRows joined_;
  std::vector<char> is_used_;     // per row, by a column alive
  std::vector<int> part_of_set_;  // per row that stands for its set
  std::vector<int> number_;       // per row, in its part
  std::vector<Part> parts_;
};

}  // namespace

std::vector<Part> parts_of(const Packing& packing, std::span<const Steps> prices,
                           std::span<const char> alive) {
  return Splitter(packing, prices, alive).split();
}

std::vector<Part> parts_beyond(const Packing& packing, std::span<const Steps> prices,
                               const Pricing& pricing, Steps ceiling, std::span<const int> choice) {
  const std::vector<char> alive = alive_columns(pricing, ceiling);
  Splitter splitter(packing, prices, alive);
  splitter.settle(pricing.reduced, choice);
  return splitter.split();
}

}  // namespace mda
