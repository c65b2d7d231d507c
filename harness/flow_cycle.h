// Cycles in graphs that must not have any.
#pragma once

#include <cstddef>
#include <optional>

#include "algorithms/api/flow.h"

namespace mda {

/// The last arc, in the graph's order, of some cycle of arcs, whatever their capacities; nothing
/// without a cycle. O(nodes + arcs).
[[nodiscard]] std::optional<std::size_t> arc_that_closes_a_cycle(const FlowGraph& graph);

}  // namespace mda
