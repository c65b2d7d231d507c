#include "algorithms/backends/min_cost_flow.h"

#include <lemon/network_simplex.h>
#include <lemon/static_graph.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace mda {
namespace {

using Graph = lemon::StaticDigraph;
using Simplex = lemon::NetworkSimplex<Graph, std::int64_t, std::int64_t>;

/// Arc numbers in the order of their tails, which is how a StaticDigraph numbers them.
std::vector<int> arcs_by_tail(const std::vector<FlowArc>& arcs) {
  std::vector<int> order(arcs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return arcs[static_cast<std::size_t>(a)].tail < arcs[static_cast<std::size_t>(b)].tail;
  });
  return order;
}

}  // namespace

std::vector<std::int64_t> min_cost_flow(const FlowGraph& graph) {
  const std::vector<int> order = arcs_by_tail(graph.arcs);
  std::vector<std::pair<int, int>> ends;
  for (const int a : order) {
    const FlowArc& arc = graph.arcs[static_cast<std::size_t>(a)];
    ends.emplace_back(arc.tail, arc.head);
  }
  Graph digraph;
  digraph.build(graph.nodes, ends.begin(), ends.end());
  Graph::ArcMap<std::int64_t> capacity(digraph);
  Graph::ArcMap<std::int64_t> cost(digraph);
  Graph::NodeMap<std::int64_t> supply(digraph);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const FlowArc& arc = graph.arcs[static_cast<std::size_t>(order[i])];
    capacity[Graph::arc(static_cast<int>(i))] = arc.capacity;
    cost[Graph::arc(static_cast<int>(i))] = arc.cost;
  }
  for (int n = 0; n < graph.nodes; ++n) {
    supply[Graph::node(n)] = graph.supply[static_cast<std::size_t>(n)];
  }
  Simplex simplex(digraph);
  simplex.upperMap(capacity).costMap(cost).supplyMap(supply);
  if (simplex.run() != Simplex::OPTIMAL) return {};
  std::vector<std::int64_t> flow(graph.arcs.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    flow[static_cast<std::size_t>(order[i])] = simplex.flow(Graph::arc(static_cast<int>(i)));
  }
  return flow;
}

}  // namespace mda
