// Connected components of what prices leave of a packing.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "algorithms/certified/pricing.h"

namespace mda {

/// A component, with the prices of its rows and the bound that they prove for it alone.
struct Part {
  Packing packing;
  std::vector<Steps> prices;
  Steps bound = 0;
  /// Where a known choice costs the bound: its columns, in numbers of the window. Nothing is left
  /// to do, and of the packing there are the rows alone.
  std::optional<std::vector<int>> choice;
};

/// The components of the columns that are `alive` (one flag per column), the smallest first. Prices
/// are folded into the roots. The bounds add up to the bound of the whole, or to more, since rows
/// that no column is left for drop out. O(nonzeros + parts log parts).
[[nodiscard]] std::vector<Part> parts_of(const Packing& packing, std::span<const Steps> prices,
                                         std::span<const char> alive);

/// The same of the columns that a choice cheaper than `ceiling` may have; but all components in
/// which `choice` (columns of the packing) costs their bound and nothing beyond it are one part,
/// the first. Most are: what a choice costs beyond the bound is lost in few places.
[[nodiscard]] std::vector<Part> parts_beyond(const Packing& packing, std::span<const Steps> prices,
                                             const Pricing& pricing, Steps ceiling,
                                             std::span<const int> choice);

}  // namespace mda
