#include "algorithms/certified/pricing.h"

#include <algorithm>
#include <limits>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Finds the reduced costs of columns `begin` up to `end`, and returns the least.
Steps price_columns(const Packing& packing, std::span<const Steps> prices, int begin, int end,
                    std::vector<Steps>& reduced) {
  Steps least = std::numeric_limits<Steps>::max();
  for (int j = begin; j < end; ++j) {
    Steps sum = packing.cost[index(j)];
    for (const int r : packing.rows_of(j)) sum += prices[index(r)];
    reduced[index(j)] = sum;
    least = std::min(least, sum);
  }
  return least;
}

}  // namespace

void price(const Packing& packing, std::span<const Steps> prices, Pricing& pricing) {
  pricing.reduced.resize(packing.cost.size());
  pricing.least.resize(packing.root.size());
  pricing.bound = 0;
  for (const Steps y : prices) pricing.bound -= y;
  for (int t = 0; t < packing.trees(); ++t) {
    const Steps least = price_columns(packing, prices, packing.tree_begin[index(t)],
                                      packing.tree_begin[index(t) + 1], pricing.reduced);
    pricing.least[index(t)] = least;
    pricing.bound += std::min<Steps>(0, least);
  }
}

void fold_into_roots(const Packing& packing, std::vector<Steps>& prices, Pricing& pricing) {
  pricing.reduced.resize(packing.cost.size());
  pricing.least.resize(packing.root.size());
  // The last trees first: their roots may be in columns of earlier trees, never the other way
  // round.
  for (int t = packing.trees() - 1; t >= 0; --t) {
    const int begin = packing.tree_begin[index(t)];
    const int end = packing.tree_begin[index(t) + 1];
    const Steps least = price_columns(packing, prices, begin, end, pricing.reduced);
    pricing.least[index(t)] = std::max<Steps>(0, least);
    if (least >= 0) continue;
    prices[index(packing.root[index(t)])] -= least;
    for (int j = begin; j < end; ++j) pricing.reduced[index(j)] -= least;
  }
  pricing.bound = 0;
  for (const Steps y : prices) pricing.bound -= y;
}

std::vector<char> alive_columns(const Pricing& pricing, Steps ceiling) {
  std::vector<char> alive(pricing.reduced.size());
  const Steps most = ceiling - kGrid - pricing.bound;
  for (std::size_t j = 0; j < alive.size(); ++j) alive[j] = pricing.reduced[j] <= most ? 1 : 0;
  return alive;
}

}  // namespace mda
