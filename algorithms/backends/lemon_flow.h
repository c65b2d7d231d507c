// Minimum-cost flow by the codes of LEMON. This header and its source are C++17, the newest
// standard that all of LEMON compiles under.
#pragma once

#include "algorithms/api/flow.h"

namespace mda {

// All three decline graphs whose costs are out of range (fits_flow_codes). Exponential, or
// pseudo-polynomial, in the worst case; in practice about O(nodes x arcs).

/// Network simplex, by block search.
[[nodiscard]] FlowResult network_simplex_flow(const FlowGraph& graph);

/// Capacity scaling: with capacities of 1 the same as successive shortest paths.
[[nodiscard]] FlowResult capacity_scaling_flow(const FlowGraph& graph);

/// Cost scaling: push-relabel with partial augmentation.
[[nodiscard]] FlowResult cost_scaling_flow(const FlowGraph& graph);

}  // namespace mda
