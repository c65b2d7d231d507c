// The best that the columns of several choices make together.
#pragma once

#include <span>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/certified/parts.h"

namespace mda {

/// Chooses from the columns marked `alive` alone, one connected part of them after the other: the
/// best there is where that can be enumerated in a few thousand nodes, else what the best of
/// `choices` has there. Two choices differ in small pieces that have nothing to do with each other,
/// so the best pieces of both are found at once. Returns columns of the packing; not dearer than
/// any of `choices`, whose columns must be alive. `prices` are folded into the roots.
///
/// Source: optimal recombination, Haller and Savchynskyy 2024 (arXiv 2408.02086), which hands the
/// union of two solutions to a general solver; here it is enumerated.
[[nodiscard]] std::vector<int> recombined(const Packing& packing, std::span<const Steps> prices,
                                          std::span<const char> alive,
                                          std::span<const std::vector<int>> choices,
                                          const Budget& budget);

}  // namespace mda
