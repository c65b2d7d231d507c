#include "algorithms/api/flow.h"

#include <stdexcept>

namespace mda {
namespace {

__extension__ using Wide = __int128;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool fits(Wide value) { return value <= INT64_MAX && value >= INT64_MIN; }

}  // namespace

std::int64_t flow_cost(const FlowGraph& graph, const std::vector<std::int64_t>& flow) {
  Wide cost = 0;
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    cost += static_cast<Wide>(flow[a]) * graph.arcs[a].cost;
  }
  if (!fits(cost)) throw std::overflow_error("the cost of the flow is outside 64 bits");
  return static_cast<std::int64_t>(cost);
}

std::string flow_fault(const FlowGraph& graph, const std::vector<std::int64_t>& flow) {
  if (flow.size() != graph.arcs.size()) return "there is not one flow per arc";
  std::vector<Wide> left(index(graph.nodes));
  for (int n = 0; n < graph.nodes; ++n) left[index(n)] = graph.supply[index(n)];
  for (std::size_t a = 0; a < flow.size(); ++a) {
    const FlowArc& arc = graph.arcs[a];
    if (flow[a] < 0 || flow[a] > arc.capacity) {
      return "arc " + std::to_string(a) + " has a flow of " + std::to_string(flow[a]) +
             " and a capacity of " + std::to_string(arc.capacity);
    }
    left[index(arc.tail)] -= flow[a];
    left[index(arc.head)] += flow[a];
  }
  if (graph.source >= 0 && left[index(graph.source)] < 0) {
    left[index(graph.sink)] += left[index(graph.source)];
    left[index(graph.source)] = 0;
  }
  for (int n = 0; n < graph.nodes; ++n) {
    if (left[index(n)] != 0) return "node " + std::to_string(n) + " loses or makes flow";
  }
  return {};
}

std::optional<std::int64_t> certified_flow_bound(const FlowGraph& graph,
                                                 const std::vector<std::int64_t>& potential) {
  if (potential.size() != index(graph.nodes)) return std::nullopt;
  const auto y = [&](int node) { return static_cast<Wide>(potential[index(node)]); };
  if (graph.source >= 0 && y(graph.source) > y(graph.sink)) return std::nullopt;
  Wide bound = 0;
  for (const FlowArc& arc : graph.arcs) {
    const Wide reduced_cost = arc.cost + y(arc.tail) - y(arc.head);
    if (reduced_cost < 0) bound += arc.capacity * reduced_cost;
  }
  for (int n = 0; n < graph.nodes; ++n) bound -= graph.supply[index(n)] * y(n);
  if (!fits(bound)) return std::nullopt;
  return static_cast<std::int64_t>(bound);
}

}  // namespace mda
