// Nearest neighbour: every track looks for itself.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// For problems with at most two dimensions: every row of the lower dimension (the tracks, if there
/// are any) wants its own cheapest column. A plot wanted by several goes to the one that gains the
/// most over being without a plot; the others get no second choice, but what they have alone.
/// Plots that nobody wants are used alone where that is cheaper than nothing or must be. The order
/// of tracks does not matter, but for ties. O(columns).
/// Source: Bar-Shalom and Li, "Multitarget-Multisensor Tracking: Principles and Techniques" (1995),
/// for the idea; contested plots are not settled there.
[[nodiscard]] std::unique_ptr<Associator> make_nn();

}  // namespace mda
