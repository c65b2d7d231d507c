#include "algorithms/certified/swap_search.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kFree = -1;
constexpr int kMostTries = 16;  // columns to fill a row with

}  // namespace

SwapSearch::SwapSearch(const Packing& packing, std::vector<Steps> prices, const Pricing& pricing,
                       Steps band)
    : packing_(packing),
      prices_(std::move(prices)),
      excess_(packing.cost.size()),
      row_begin_(index(packing.rows()) + 1, 0) {
  for (int t = 0; t < packing.trees(); ++t) {
    const Steps least = std::min<Steps>(0, pricing.least[index(t)]);
    for (int j = packing.tree_begin[index(t)]; j < packing.tree_begin[index(t) + 1]; ++j) {
      excess_[index(j)] = pricing.reduced[index(j)] - least;
      if (excess_[index(j)] <= band) candidates_.push_back(j);
    }
  }
  std::ranges::sort(candidates_, {}, [&](int j) {
    return std::tuple(excess_[index(j)], packing.cost[index(j)], j);
  });
  for (const int j : candidates_) {
    for (const int r : packing.rows_of(j)) ++row_begin_[index(r) + 1];
  }
  for (int r = 0; r < packing.rows(); ++r) row_begin_[index(r) + 1] += row_begin_[index(r)];
  by_row_.resize(index(row_begin_.back()));
  std::vector<int> next(row_begin_.begin(), row_begin_.end() - 1);
  for (const int j : candidates_) {
    for (const int r : packing.rows_of(j)) by_row_[index(next[index(r)]++)] = j;
  }
}

void SwapSearch::start(std::span<const int> choice) {
  owner_.assign(index(packing_.rows()), kFree);
  chosen_.assign(packing_.cost.size(), 0);
  is_stale_.assign(index(packing_.rows()), 0);
  stale_.clear();
  moves_.clear();
  cost_ = 0;
  for (const int j : choice) {
    if (fits(j)) put(j);
  }
  for (const int j : candidates_) {
    if (fits(j)) put(j);
  }
  moves_.clear();
  collect_choice();
}

bool SwapSearch::fits(int column) const {
  const auto rows = packing_.rows_of(column);
  return std::ranges::all_of(rows, [&](int r) { return owner_[index(r)] == kFree; });
}

void SwapSearch::put(int column) {
  for (const int r : packing_.rows_of(column)) owner_[index(r)] = column;
  chosen_[index(column)] = 1;
  cost_ += packing_.cost[index(column)];
  moves_.push_back({column, true});
}

void SwapSearch::take(int column) {
  for (const int r : packing_.rows_of(column)) owner_[index(r)] = kFree;
  chosen_[index(column)] = 0;
  cost_ -= packing_.cost[index(column)];
  moves_.push_back({column, false});
}

void SwapSearch::undo(std::size_t moves_to_keep) {
  while (moves_.size() > moves_to_keep) {
    const Move last = moves_.back();
    if (last.put) {
      take(last.column);
    } else {
      put(last.column);
    }
    moves_.resize(moves_.size() - 2);  // what it was, and its undoing
  }
}

bool SwapSearch::may_gain(int column) const {
  Steps gain = -excess_[index(column)];
  int last = kFree;
  for (const int r : packing_.rows_of(column)) {
    const int owner = owner_[index(r)];
    if (owner == kFree) {
      gain += prices_[index(r)];
    } else if (owner != last) {  // one that comes again later counts twice: a try for nothing
      gain += excess_[index(owner)];
      last = owner;
    }
  }
  return gain > 0;
}

/// Fills the rows that moves since then have left free.
void SwapSearch::fill(std::size_t moved_before) {
  const std::size_t moved = moves_.size();
  for (std::size_t m = moved_before; m < moved; ++m) {
    if (moves_[m].put) continue;
    for (const int r : packing_.rows_of(moves_[m].column)) {
      const int end = std::min(row_begin_[index(r)] + kMostTries, row_begin_[index(r) + 1]);
      for (int c = row_begin_[index(r)]; c < end && owner_[index(r)] == kFree; ++c) {
        if (fits(by_row_[index(c)])) put(by_row_[index(c)]);
      }
    }
  }
}

bool SwapSearch::swap(int column, bool even_at_a_loss) {
  const Steps before = cost_;
  const std::size_t moved_before = moves_.size();
  for (const int r : packing_.rows_of(column)) {
    if (owner_[index(r)] != kFree) take(owner_[index(r)]);
  }
  put(column);
  fill(moved_before);
  const bool gained = cost_ < before;
  if (!gained && !even_at_a_loss) {
    undo(moved_before);
    return false;
  }
  for (std::size_t m = moved_before; m < moves_.size(); ++m) {
    for (const int r : packing_.rows_of(moves_[m].column)) {
      if (is_stale_[index(r)] != 0) continue;
      is_stale_[index(r)] = 1;
      stale_.push_back(r);
    }
  }
  return gained;
}

void SwapSearch::descend() {
  while (!stale_.empty()) {
    const int r = stale_.back();
    stale_.pop_back();
    is_stale_[index(r)] = 0;
    for (int c = row_begin_[index(r)]; c < row_begin_[index(r) + 1]; ++c) {
      const int j = by_row_[index(c)];
      if (chosen_[index(j)] == 0 && may_gain(j)) swap(j, false);
    }
  }
}

void SwapSearch::improve(int kicks, const Budget& budget) {
  for (int r = packing_.rows() - 1; r >= 0; --r) {
    stale_.push_back(r);
    is_stale_[index(r)] = 1;
  }
  descend();
  for (const int j : candidates_) {
    if (kicks <= 0 || budget.expired()) break;
    if (chosen_[index(j)] != 0) continue;
    --kicks;
    moves_.clear();
    const Steps before = cost_;
    swap(j, true);
    descend();
    if (cost_ >= before) undo(0);
  }
  collect_choice();
}

void SwapSearch::collect_choice() {
  choice_.clear();
  for (int j = 0; j < packing_.columns(); ++j) {
    if (chosen_[index(j)] != 0) choice_.push_back(j);
  }
}

}  // namespace mda
