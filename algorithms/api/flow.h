// Minimum-cost flow: the form in which flow codes are given a graph, and what they answer. Costs
// are integers, so that codes can be compared exactly. Compiles as C++17 too, for the libraries
// that need it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mda {

struct FlowArc {
  int tail = 0;
  int head = 0;
  std::int64_t capacity = 1;  ///< not negative
  std::int64_t cost = 0;      ///< per unit
};

/// Nodes are numbered from 0, in no particular order. Parallel arcs are allowed.
struct FlowGraph {
  int nodes = 0;
  std::vector<std::int64_t> supply;  ///< per node, negative for demand; they sum to 0
  std::vector<FlowArc> arcs;
  /// Beside the supplies, any amount of flow, none included, may go from source to sink, whichever
  /// costs least; -1, -1: there is no such thing.
  int source = -1;
  int sink = -1;
};

enum class FlowOutcome : std::uint8_t {
  kOptimal,
  kInfeasible,  ///< the supplies cannot be met
  kDeclined     ///< not a graph for this code, or its numbers are out of range: see `reason`
};

/// A claim that the referee checks (certified_flow_bound).
struct FlowResult {
  FlowOutcome outcome = FlowOutcome::kInfeasible;
  std::vector<std::int64_t> flow;  ///< per arc, integral; empty without an optimum
  /// Node potentials that prove it; the certificate of
  ///   sum_a capacity_a min(0, cost_a + y_tail - y_head) + sum_v supply_v (-y_v),
  /// a lower bound on the cost for any y with y_source <= y_sink.
  std::vector<std::int64_t> potential;
  std::string reason;
  int reason_node = -1;  ///< the node that `reason` is about, or -1
  /// Of a code that solves the linear programme: values of its optimum that are not whole.
  std::optional<int> lp_fractional;
};

/// A code for minimum-cost flow.
using SolveFlow = FlowResult (*)(const FlowGraph&);

/// The largest number a code may be given: sizes of costs beyond it overflow some library's 64 bits
/// (LEMON's cost scaling then never returns).
[[nodiscard]] inline bool fits_flow_codes(const FlowGraph& graph) {
  const auto limit = (INT64_MAX / 16) / (static_cast<std::int64_t>(graph.nodes) + 1);
  for (const FlowArc& arc : graph.arcs) {
    if (arc.cost > limit || arc.cost < -limit) return false;
  }
  return true;
}

// What anybody can check of an answer, without any code's word.

/// sum_a flow_a cost_a. Throws std::overflow_error outside 64 bits.
[[nodiscard]] std::int64_t flow_cost(const FlowGraph& graph, const std::vector<std::int64_t>& flow);

/// One sentence about the first arc or node that breaks capacity or conservation, or an empty text.
[[nodiscard]] std::string flow_fault(const FlowGraph& graph, const std::vector<std::int64_t>& flow);

/// The bound that potentials certify (FlowResult::potential); nothing if they certify none: not one
/// per node, y_source > y_sink, or a bound outside 64 bits. O(nodes + arcs).
[[nodiscard]] std::optional<std::int64_t> certified_flow_bound(
    const FlowGraph& graph, const std::vector<std::int64_t>& potential);

}  // namespace mda
