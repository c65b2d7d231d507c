#include "algorithms/certified/ascent.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

constexpr int kMostRounds = 12;
constexpr int kFirstSweeps = 4;
constexpr int kSweeps = 3;
/// A round that gains less than this share of the gap is idle; two idle rounds end the ascent.
constexpr int kIdleShare = 50;
/// The working set's band, as a share of the mean gain of a tree's best column.
constexpr int kBandShare = 64;

}  // namespace

AscentResult DualAscent::run(const Packing& packing, const Budget& budget) {
  AscentResult result;
  result.prices.assign(index(packing.rows()), 0);
  result.bound = std::numeric_limits<Steps>::min() / 2;
  start(packing);
  int idle = 0;
  for (;;) {
    const Steps gained = pricing_.bound - result.bound;
    if (gained > 0) {
      result.bound = pricing_.bound;
      result.prices = prices_;
    }
    idle = gained < (result.cost - result.bound) / kIdleShare ? idle + 1 : 0;
    result.expired = budget.expired();
    if (result.closed() || result.rounds == kMostRounds || idle == 2 || result.expired) break;
    widen_working_set();
    sweep(result.rounds == 0 ? kFirstSweeps : kSweeps);
    choose_greedily(result);
    price(packing, prices_, pricing_);
    ++result.rounds;
  }
  return result;
}

void DualAscent::start(const Packing& packing) {
  packing_ = &packing;
  prices_.assign(index(packing.rows()), 0);
  in_set_.assign(packing.cost.size(), 0);
  upwards_ = true;
  price(packing, prices_, pricing_);
  band_ = packing.trees() == 0 ? 0 : -pricing_.bound / (kBandShare * packing.trees());
}

/// Columns never leave the set: those that are far above now may be needed later.
void DualAscent::widen_working_set() {
  for (int t = 0; t < packing_->trees(); ++t) {
    const Steps most = pricing_.least[index(t)] + band_;
    for (int j = packing_->tree_begin[index(t)]; j < packing_->tree_begin[index(t) + 1]; ++j) {
      if (pricing_.reduced[index(j)] <= most) in_set_[index(j)] = 1;
    }
  }
  index_working_set();
}

void DualAscent::index_working_set() {
  const Packing& packing = *packing_;
  column_.clear();
  reduced_.clear();
  tree_begin_.assign(1, 0);
  row_begin_.assign(index(packing.rows()) + 1, 0);
  for (int t = 0; t < packing.trees(); ++t) {
    for (int j = packing.tree_begin[index(t)]; j < packing.tree_begin[index(t) + 1]; ++j) {
      if (in_set_[index(j)] == 0) continue;
      column_.push_back(j);
      reduced_.push_back(pricing_.reduced[index(j)]);
      for (const int r : packing.rows_of(j)) ++row_begin_[index(r) + 1];
    }
    tree_begin_.push_back(static_cast<int>(column_.size()));
  }
  for (int r = 0; r < packing.rows(); ++r) row_begin_[index(r) + 1] += row_begin_[index(r)];
  positions_.resize(index(row_begin_.back()));
  std::vector<int> next(row_begin_.begin(), row_begin_.end() - 1);
  for (int i = 0; i < static_cast<int>(column_.size()); ++i) {
    for (const int r : packing.rows_of(column_[index(i)])) {
      positions_[index(next[index(r)]++)] = i;
    }
  }
  group_begin_.assign(1, 0);
  groups_.clear();
  for (int r = 0; r < packing.rows(); ++r) {
    int tree = -1;
    for (int p = row_begin_[index(r)]; p < row_begin_[index(r) + 1]; ++p) {
      const int position = positions_[index(p)];
      if (tree < 0 || position >= tree_begin_[index(tree) + 1]) {
        tree = static_cast<int>(std::ranges::upper_bound(tree_begin_, position) -
                                tree_begin_.begin()) -
               1;
        groups_.push_back({tree, p, p});
      }
      groups_.back().last = p + 1;
    }
    group_begin_.push_back(static_cast<int>(groups_.size()));
  }
  time_ = 1;
  tree_changed_.assign(index(packing.trees()), 1);
  row_visited_.assign(index(packing.rows()), 0);
}

void DualAscent::sweep(int sweeps) {
  const int rows = packing_->rows();
  for (int s = 0; s < sweeps; ++s, upwards_ = !upwards_) {
    for (int i = 0; i < rows; ++i) {
      const int r = upwards_ ? i : rows - 1 - i;
      if (!is_settled(r)) improve(r);
    }
  }
}

/// A row that one tree alone wants is worth nothing.
bool DualAscent::is_settled(int row) const {
  if (group_begin_[index(row) + 1] - group_begin_[index(row)] < 2) return true;
  for (int g = group_begin_[index(row)]; g < group_begin_[index(row) + 1]; ++g) {
    if (tree_changed_[index(groups_[index(g)].tree)] > row_visited_[index(row)]) return false;
  }
  return true;
}

/// A tree gives the row up when its price exceeds what the tree's best column with the row is
/// better than its best column without it, or than none.
void DualAscent::improve(int row) {
  Steps largest = 0;
  Steps second = 0;
  for (int g = group_begin_[index(row)]; g < group_begin_[index(row) + 1]; ++g) {
    const Group& group = groups_[index(g)];
    Steps with = std::numeric_limits<Steps>::max();
    Steps without = 0;
    int next = group.first;
    const int end = tree_begin_[index(group.tree) + 1];
    for (int i = tree_begin_[index(group.tree)]; i < end; ++i) {
      Steps& best = next < group.last && positions_[index(next)] == i ? (++next, with) : without;
      best = std::min(best, reduced_[index(i)]);
    }
    const Steps limit = without - (with - prices_[index(row)]);
    if (limit > largest) {
      second = largest;
      largest = limit;
    } else {
      second = std::max(second, limit);
    }
  }
  move_price(row, (largest + second) / 2);
  row_visited_[index(row)] = time_;
}

void DualAscent::move_price(int row, Steps price) {
  const Steps change = price - prices_[index(row)];
  if (change == 0) return;
  prices_[index(row)] = price;
  ++time_;
  for (int p = row_begin_[index(row)]; p < row_begin_[index(row) + 1]; ++p) {
    reduced_[index(positions_[index(p)])] += change;
  }
  for (int g = group_begin_[index(row)]; g < group_begin_[index(row) + 1]; ++g) {
    tree_changed_[index(groups_[index(g)].tree)] = time_;
  }
}

void DualAscent::choose_greedily(AscentResult& result) {
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(column_.size()); ++i) {
    if (reduced_[index(i)] <= 0) order.push_back(i);
  }
  std::ranges::sort(order, {}, [&](int i) {
    const int j = column_[index(i)];
    return std::tuple(reduced_[index(i)], packing_->cost[index(j)], j);
  });
  std::vector<char> used(index(packing_->rows()), 0);
  std::vector<int> choice;
  for (const int i : order) {
    const int j = column_[index(i)];
    const auto rows = packing_->rows_of(j);
    if (std::ranges::any_of(rows, [&](int r) { return used[index(r)] != 0; })) continue;
    for (const int r : rows) used[index(r)] = 1;
    choice.push_back(j);
  }
  const Steps cost = cost_of(*packing_, choice);
  if (cost >= result.cost) return;
  result.cost = cost;
  result.choice = std::move(choice);
}

}  // namespace mda
