// Connected components of what prices leave of a packing.
#pragma once

#include <span>
#include <vector>

#include "algorithms/certified/pricing.h"

namespace mda {

/// A component, with the prices of its rows and the bound that they prove for it alone.
struct Part {
  Packing packing;
  std::vector<Steps> prices;
  Steps bound = 0;
};

/// The components of the columns that are `alive` (one flag per column), the smallest first. Prices
/// are folded into the roots. The bounds add up to the bound of the whole, or to more, since rows
/// that no column is left for drop out. O(nonzeros + parts log parts).
[[nodiscard]] std::vector<Part> parts_of(const Packing& packing, std::span<const Steps> prices,
                                         std::span<const char> alive);

}  // namespace mda
