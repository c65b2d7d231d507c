#include "algorithms/certified/pricing.h"

#include <algorithm>
#include <limits>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace

void price(const Packing& packing, std::span<const Steps> prices, Pricing& pricing) {
  pricing.reduced.resize(packing.cost.size());
  pricing.least.resize(packing.root.size());
  pricing.bound = 0;
  for (const Steps y : prices) pricing.bound -= y;
  for (int t = 0; t < packing.trees(); ++t) {
    Steps least = std::numeric_limits<Steps>::max();
    for (int j = packing.tree_begin[index(t)]; j < packing.tree_begin[index(t) + 1]; ++j) {
      Steps reduced = packing.cost[index(j)];
      for (const int r : packing.rows_of(j)) reduced += prices[index(r)];
      pricing.reduced[index(j)] = reduced;
      least = std::min(least, reduced);
    }
    pricing.least[index(t)] = least;
    pricing.bound += std::min<Steps>(0, least);
  }
}

void fold_into_roots(const Packing& packing, std::vector<Steps>& prices, Pricing& pricing) {
  // The last trees first: their roots may be in columns of earlier trees, never the other way
  // round.
  for (int t = packing.trees() - 1; t >= 0; --t) {
    Steps least = 0;
    for (int j = packing.tree_begin[index(t)]; j < packing.tree_begin[index(t) + 1]; ++j) {
      Steps reduced = packing.cost[index(j)];
      for (const int r : packing.rows_of(j)) reduced += prices[index(r)];
      least = std::min(least, reduced);
    }
    prices[index(packing.root[index(t)])] -= least;
  }
  price(packing, prices, pricing);
}

std::vector<char> alive_columns(const Pricing& pricing, Steps ceiling) {
  std::vector<char> alive(pricing.reduced.size());
  const Steps most = ceiling - kGrid - pricing.bound;
  for (std::size_t j = 0; j < alive.size(); ++j) alive[j] = pricing.reduced[j] <= most ? 1 : 0;
  return alive;
}

}  // namespace mda
