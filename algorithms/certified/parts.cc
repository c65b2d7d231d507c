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

}  // namespace

std::vector<Part> parts_of(const Packing& packing, std::span<const Steps> prices,
                           std::span<const char> alive) {
  JoinedRows joined(packing.rows());
  std::vector<char> used(index(packing.rows()), 0);
  for (int j = 0; j < packing.columns(); ++j) {
    if (alive[index(j)] == 0) continue;
    const auto rows = packing.rows_of(j);
    for (const int r : rows) {
      used[index(r)] = 1;
      if (r != rows[0]) joined.join(r, rows[0]);
    }
  }
  std::vector<Part> parts;
  std::vector<int> part_of_set(index(packing.rows()), kNone);
  std::vector<int> number(index(packing.rows()), kNone);
  for (int r = 0; r < packing.rows(); ++r) {
    if (used[index(r)] == 0) continue;
    int& p = part_of_set[index(joined.root(r))];
    if (p == kNone) {
      p = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    Part& part = parts[index(p)];
    number[index(r)] = part.packing.rows();
    part.packing.row_origin.push_back(packing.row_origin[index(r)]);
    part.prices.push_back(prices[index(r)]);
    part.bound -= prices[index(r)];
  }
  for (int t = 0; t < packing.trees(); ++t) {
    const int root = packing.root[index(t)];
    if (used[index(root)] == 0) continue;
    Packing& part = parts[index(part_of_set[index(joined.root(root))])].packing;
    const int before = part.columns();
    for (int j = packing.tree_begin[index(t)]; j < packing.tree_begin[index(t) + 1]; ++j) {
      if (alive[index(j)] == 0) continue;
      for (const int r : packing.rows_of(j)) part.row.push_back(number[index(r)]);
      part.begin.push_back(static_cast<int>(part.row.size()));
      part.cost.push_back(packing.cost[index(j)]);
      part.origin.push_back(packing.origin[index(j)]);
    }
    if (part.columns() == before) continue;
    part.root.push_back(number[index(root)]);
    part.tree_begin.push_back(part.columns());
  }
  std::ranges::stable_sort(parts, {}, [](const Part& part) { return part.packing.columns(); });
  return parts;
}

}  // namespace mda
