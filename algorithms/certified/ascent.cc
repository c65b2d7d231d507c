#include "algorithms/certified/ascent.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

constexpr int kMostRounds = 80;
constexpr int kRoundsBelowTheMiddle = 8;
/// A round that gains less than this share of the gap is idle; some in a row end the ascent.
constexpr int kIdleShare = 25;
/// The working set's band, as a share of the mean gain of a tree's best column.
constexpr int kBandShare = 16;

/// The bound is best at every price from `second` to `largest`. One that is well within stays, so
/// that rows settle; else it goes below the middle at first, where more columns are worth choosing,
/// and to the middle later, which finds better bounds. The shares were found by trying a few on
/// windows of A-D and of the easy scenarios, as were the numbers above.
Steps best_price(Steps price, Steps second, Steps largest, bool in_the_middle) {
  const Steps width = largest - second;
  const Steps margin = width * (in_the_middle ? 45 : 10) / 100;
  if (price >= second + margin && price <= largest - margin) return price;
  return second + width * (in_the_middle ? 50 : 30) / 100;
}

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
    const bool gives_up = result.rounds == kMostRounds || idle == patience_;
    if (result.closed() || gives_up || result.expired) break;
    if (result.rounds == kRoundsBelowTheMiddle) move_to_the_middle();
    widen_working_set();
    sweep();
    choose_greedily(result);
    price_changed_trees();
    ++result.rounds;
  }
  return result;
}

void DualAscent::start(const Packing& packing) {
  packing_ = &packing;
  link_finder_.find(packing, links_);
  set_.start(packing, links_);
  prices_.assign(index(packing.rows()), 0);
  pricing_.reduced = packing.cost;
  pricing_.least.resize(index(packing.trees()));
  path_price_.assign(index(links_.nodes()), 0);
  is_changed_.assign(index(packing.trees()), 1);
  time_ = 0;
  tree_changed_.assign(index(packing.trees()), 0);
  limits_.assign(links_.row.size(), {.price = 0, .time = -1});
  upwards_ = true;
  in_the_middle_ = false;
  pricing_.bound = 0;
  for (int t = 0; t < packing.trees(); ++t) {
    const auto first = packing.cost.begin() + packing.tree_begin[index(t)];
    const auto last = packing.cost.begin() + packing.tree_begin[index(t) + 1];
    pricing_.least[index(t)] = *std::min_element(first, last);
    pricing_.bound += pricing_.least[index(t)];
  }
  band_ = packing.trees() == 0 ? 0 : -pricing_.bound / (kBandShare * packing.trees());
}

/// Columns never leave the set: those that are far above now may be needed later.
void DualAscent::widen_working_set() {
  ++time_;
  for (int t = 0; t < packing_->trees(); ++t) {
    if (is_changed_[index(t)] == 0) continue;
    is_changed_[index(t)] = 0;
    const Steps most = pricing_.least[index(t)] + band_;
    if (set_.widen(t, pricing_.reduced, most)) tree_changed_[index(t)] = time_;
  }
}

void DualAscent::move_to_the_middle() {
  in_the_middle_ = true;
  for (Limit& limit : limits_) limit.time = -1;  // rows that had settled are looked at again
}

void DualAscent::sweep() {
  const int rows = packing_->rows();
  for (int i = 0; i < rows; ++i) improve(upwards_ ? i : rows - 1 - i);
  upwards_ = !upwards_;
}

/// A row that one tree alone wants is worth nothing. The price at which a tree gives the row up
/// does not depend on the present price, so it stays what it is until another price of the tree
/// changes.
void DualAscent::improve(int row) {
  const auto links = set_.links_of(row);
  if (links.size() < 2) return;
  bool is_settled = true;
  Steps largest = 0;
  Steps second = 0;
  for (const int l : links) {
    Limit& limit = limits_[index(l)];
    if (limit.time < tree_changed_[index(links_.tree[index(l)])]) {
      limit.price = prices_[index(row)] + set_.worth(l);
      is_settled = false;
    }
    if (limit.price > largest) {
      second = largest;
      largest = limit.price;
    } else {
      second = std::max(second, limit.price);
    }
  }
  if (is_settled) return;
  move_price(row, best_price(prices_[index(row)], second, largest, in_the_middle_));
  for (const int l : links) limits_[index(l)].time = time_;
}

void DualAscent::move_price(int row, Steps price) {
  const Steps change = price - prices_[index(row)];
  if (change == 0) return;
  prices_[index(row)] = price;
  ++time_;
  for (const int l : set_.links_of(row)) {
    set_.move(l, change);
    tree_changed_[index(links_.tree[index(l)])] = time_;
  }
  for (const int l : links_.of_row(row)) is_changed_[index(links_.tree[index(l)])] = 1;
}

void DualAscent::price_changed_trees() {
  pricing_.bound = -std::reduce(prices_.begin(), prices_.end(), Steps{0});
  for (int t = 0; t < packing_->trees(); ++t) {
    if (is_changed_[index(t)] != 0) price_tree(t);
    pricing_.bound += std::min<Steps>(0, pricing_.least[index(t)]);
  }
}

void DualAscent::price_tree(int tree) {
  const int end_node = links_.node_begin[index(tree) + 1];
  for (int n = links_.node_begin[index(tree)]; n < end_node; ++n) {
    const auto [parent, link] = links_.node[index(n)];
    const int row = links_.row[index(link)];
    path_price_[index(n)] = path_price_[index(parent)] + prices_[index(row)];
  }
  Steps least = std::numeric_limits<Steps>::max();
  for (int j = packing_->tree_begin[index(tree)]; j < packing_->tree_begin[index(tree) + 1]; ++j) {
    const int node = links_.node_of_column[index(j)];
    const Steps reduced = packing_->cost[index(j)] + path_price_[index(node)];
    pricing_.reduced[index(j)] = reduced;
    least = std::min(least, reduced);
  }
  pricing_.least[index(tree)] = least;
}

/// One tree after the other: its column of least reduced cost, 0 at most, that fits.
void DualAscent::choose_greedily(AscentResult& result) {
  used_.assign(index(packing_->rows()), 0);
  choice_.clear();
  Steps cost = 0;
  for (int t = 0; t < packing_->trees(); ++t) {
    const int column = best_that_fits(t);
    if (column < 0) continue;
    for (const int r : packing_->rows_of(column)) used_[index(r)] = 1;
    choice_.push_back(column);
    cost += packing_->cost[index(column)];
  }
  if (cost >= result.cost) return;
  result.cost = cost;
  result.choice = choice_;
}

int DualAscent::best_that_fits(int tree) const {
  const auto columns = set_.columns_of(tree);
  const auto reduced = set_.reduced_of(tree);
  int best = -1;
  Steps least = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (reduced[i] > least) continue;
    const int column = columns[i];
    if (best >= 0 && reduced[i] == least &&
        packing_->cost[index(column)] >= packing_->cost[index(best)]) {
      continue;
    }
    const auto rows = packing_->rows_of(column);
    if (std::ranges::any_of(rows, [&](int r) { return used_[index(r)] != 0; })) continue;
    best = column;
    least = reduced[i];
  }
  return best;
}

}  // namespace mda
