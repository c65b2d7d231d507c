// Which columns a restricted master problem begins with, and which it takes in.
#pragma once

#include <span>
#include <vector>

#include "algorithms/certified/pricing.h"

namespace mda {

/// The four columns of least reduced cost of every row; all of small packings. O(nonzeros).
[[nodiscard]] std::vector<int> first_columns(const Packing& packing,
                                             std::span<const Steps> reduced);

/// Columns of negative reduced cost that are not in the master problem (-1 in `in_master`): of
/// every tree the best three, of all trees the best 600. O(columns).
[[nodiscard]] std::vector<int> gaining_columns(const Packing& packing, const Pricing& pricing,
                                               std::span<const int> in_master);

}  // namespace mda
