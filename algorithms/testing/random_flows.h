// Small random flow graphs of disjoint paths, of all kinds, the same ones on every machine.
#pragma once

#include <cstdint>

#include "algorithms/api/flow.h"

namespace mda::testing {

/// At most some 40 nodes without a cycle; every inner node carries at most one unit. Detections are
/// arcs, chains of arcs or single nodes; there are free flows, fixed supplies and both; layered and
/// unlayered links; ties, negative and parallel arcs, arcs of no and of more capacity than they
/// need, missing starts and ends, arcs past everything. Some supplies cannot be met. Nodes and arcs
/// are in random order.
[[nodiscard]] FlowGraph random_path_flow(std::uint64_t seed);

/// The same graph with its nodes and its arcs in another order.
[[nodiscard]] FlowGraph reorder(const FlowGraph& graph, std::uint64_t seed);

}  // namespace mda::testing
