// Lagrangian prices of a packing: the bound that they prove and the columns that they rule out.
#pragma once

#include <span>
#include <vector>

#include "algorithms/certified/packing.h"

namespace mda {

/// What prices make of a packing.
struct Pricing {
  std::vector<Steps> reduced;  ///< per column, c_j + sum_{r in j} y_r
  std::vector<Steps> least;    ///< per tree, of its columns
  Steps bound = 0;             ///< L(y) of packing.h
};

/// Prices every column. O(nonzeros).
void price(const Packing& packing, std::span<const Steps> prices, Pricing& pricing);

/// Raises the price of every root by what its tree's least reduced cost is below 0, as far as it
/// still is when the tree's turn comes, and prices again. Then no column is negative and the bound,
/// minus the sum of all prices, is not worse. What a choice costs beyond the bound is the sum of
/// its columns' reduced costs and of the prices of the rows that it leaves free. O(nonzeros).
void fold_into_roots(const Packing& packing, std::vector<Steps>& prices, Pricing& pricing);

/// Columns that may be in a choice that costs less than `ceiling` (a multiple of kGrid), by prices
/// that are folded into the roots. One flag per column.
[[nodiscard]] std::vector<char> alive_columns(const Pricing& pricing, Steps ceiling);

}  // namespace mda
