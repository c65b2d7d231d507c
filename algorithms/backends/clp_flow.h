// Minimum-cost flow as a linear programme, by the dual simplex method of COIN-OR Clp.
#pragma once

#include "algorithms/api/flow.h"

namespace mda {

/// A column per arc, a row per node. Potentials are left empty where Clp's row prices, rounded to
/// integers, do not certify the cost exactly. Declines costs that,
/// times the nodes, reach 2^53, and capacities whose sum does. Throws
/// std::runtime_error if Clp gives up or its basic optimum is not integral within 1e-6.
[[nodiscard]] FlowResult clp_flow(const FlowGraph& graph);

}  // namespace mda
