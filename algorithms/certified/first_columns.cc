#include "algorithms/certified/first_columns.h"

#include <algorithm>
#include <array>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

constexpr int kSmall = 800;  // columns: up to here an LP of all of them is solved at once
constexpr int kFirstPerRow = 4;
constexpr int kMostPerTree = 3;
constexpr std::ptrdiff_t kMostPerRound = 600;

}  // namespace

std::vector<int> first_columns(const Packing& packing, std::span<const Steps> reduced) {
  std::vector<int> first;
  std::vector<char> taken(packing.cost.size(), packing.columns() <= kSmall ? 1 : 0);
  std::vector<std::array<int, kFirstPerRow>> best;
  if (packing.columns() > kSmall) best.resize(index(packing.rows()));
  for (auto& columns : best) columns.fill(-1);
  for (int j = 0; j < packing.columns() && !best.empty(); ++j) {
    for (const int r : packing.rows_of(j)) {
      int candidate = j;
      for (int& place : best[index(r)]) {
        if (candidate < 0) break;
        if (place < 0 || reduced[index(candidate)] < reduced[index(place)]) {
          std::swap(candidate, place);
        }
      }
    }
  }
  for (const auto& columns : best) {
    for (const int j : columns) {
      if (j >= 0) taken[index(j)] = 1;
    }
  }
  for (int j = 0; j < packing.columns(); ++j) {
    if (taken[index(j)] != 0) first.push_back(j);
  }
  return first;
}

std::vector<int> gaining_columns(const Packing& packing, const Pricing& pricing,
                                 std::span<const int> in_master) {
  std::vector<int> gaining;
  const auto better = [&](int a, int b) {
    return pricing.reduced[index(a)] < pricing.reduced[index(b)];
  };
  for (int t = 0; t < packing.trees(); ++t) {
    if (pricing.least[index(t)] >= 0) continue;
    const auto first = std::ssize(gaining);
    for (int j = packing.tree_begin[index(t)]; j < packing.tree_begin[index(t) + 1]; ++j) {
      if (pricing.reduced[index(j)] < 0 && in_master[index(j)] < 0) gaining.push_back(j);
    }
    if (std::ssize(gaining) - first <= kMostPerTree) continue;
    const auto keep = gaining.begin() + first + kMostPerTree;
    std::ranges::nth_element(gaining.begin() + first, keep, gaining.end(), better);
    gaining.erase(keep, gaining.end());
  }
  if (std::ssize(gaining) > kMostPerRound) {
    std::ranges::nth_element(gaining, gaining.begin() + kMostPerRound, better);
    gaining.resize(static_cast<std::size_t>(kMostPerRound));
  }
  return gaining;
}

}  // namespace mda
