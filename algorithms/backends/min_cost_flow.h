// Minimum-cost flow by LEMON's network simplex. This header and its source are C++17, the newest
// standard that LEMON compiles under: plain types only, nothing of algorithms/api.
#pragma once

#include <cstdint>
#include <vector>

namespace mda {

struct FlowArc {
  int tail = 0;
  int head = 0;
  std::int64_t capacity = 1;  ///< not negative
  std::int64_t cost = 0;      ///< per unit; the sum of all |cost| x capacity must stay below 2^62
};

struct FlowGraph {
  int nodes = 0;                     ///< numbered from 0
  std::vector<std::int64_t> supply;  ///< per node, negative for demand; they sum to 0
  std::vector<FlowArc> arcs;
};

/// The flow on every arc of a minimum-cost flow that meets all supplies and demands, or nothing if
/// there is none. Integral. Exponential in the worst case, in practice about O(nodes x arcs).
[[nodiscard]] std::vector<std::int64_t> min_cost_flow(const FlowGraph& graph);

}  // namespace mda
