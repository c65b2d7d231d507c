// Minimum-cost flow of disjoint paths, as tracking has it, solved as a one-sided assignment.
#pragma once

#include "algorithms/api/flow.h"

namespace mda {

/// For graphs without cycles in which no node but the source and the sink (or the one node of
/// demand) can carry more than one unit: the arcs into it, or those out of it, have a capacity of
/// at most 1 together. Nodes with a supply of 1 have no arc in. Anything else is declined with a
/// reason that names a node; so are costs above about INT64_MAX / (128 nodes).
/// The potentials always certify the cost exactly.
[[nodiscard]] FlowResult assignment_flow(const FlowGraph& graph);

}  // namespace mda
