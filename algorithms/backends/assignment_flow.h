// Minimum-cost flow of disjoint paths, as tracking has it, solved as a one-sided assignment.
#pragma once

#include "algorithms/api/flow.h"

namespace mda {

/// For graphs without cycles in which the arcs into an inner node, or those out of it, have a
/// capacity of at most 1 together, so that it carries one unit at most, or all have a capacity of 1
/// (JunctionSplit: in time and room that grow with arcs in x arcs out). Nodes with a supply of 1
/// have no arc in, and there is one sink or one node of demand. Anything else is declined with a
/// reason and, where it is about one, its node; so are costs above about INT64_MAX / (128 nodes).
/// The potentials always certify the cost exactly.
[[nodiscard]] FlowResult assignment_flow(const FlowGraph& graph);

}  // namespace mda
