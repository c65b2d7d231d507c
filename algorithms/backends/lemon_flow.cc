#include "algorithms/backends/lemon_flow.h"

#include <lemon/capacity_scaling.h>
#include <lemon/cost_scaling.h>
#include <lemon/network_simplex.h>
#include <lemon/static_graph.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace mda {
namespace {

using Graph = lemon::StaticDigraph;
using Number = std::int64_t;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The graph in LEMON's form. A free amount of flow becomes a circulation, by a return arc.
class LemonGraph {
 public:
  explicit LemonGraph(const FlowGraph& graph) : graph_(graph) {
    order_arcs();
    std::vector<std::pair<int, int>> ends;
    for (const int a : order_) ends.emplace_back(arc(a).tail, arc(a).head);
    digraph_.build(graph.nodes, ends.begin(), ends.end());
  }

  template <typename Code>
  FlowResult run() const {
    Graph::ArcMap<Number> capacity(digraph_);
    Graph::ArcMap<Number> cost(digraph_);
    Graph::NodeMap<Number> supply(digraph_);
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const Graph::Arc here = Graph::arc(static_cast<int>(i));
      capacity[here] = arc(order_[i]).capacity;
      cost[here] = arc(order_[i]).cost;
    }
    for (int n = 0; n < graph_.nodes; ++n) supply[Graph::node(n)] = graph_.supply[index(n)];
    Code code(digraph_);
    code.upperMap(capacity).costMap(cost).supplyMap(supply);
    FlowResult result;
    if (code.run() != Code::OPTIMAL) return result;
    result.outcome = FlowOutcome::kOptimal;
    result.flow.resize(graph_.arcs.size());
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (order_[i] == return_arc()) continue;
      result.flow[index(order_[i])] = code.flow(Graph::arc(static_cast<int>(i)));
    }
    for (int n = 0; n < graph_.nodes; ++n) {
      result.potential.push_back(code.potential(Graph::node(n)));
    }
    return result;
  }

 private:
  /// The number after those of the graph's own arcs.
  [[nodiscard]] int return_arc() const { return static_cast<int>(graph_.arcs.size()); }

  [[nodiscard]] FlowArc arc(int a) const {
    if (a != return_arc()) return graph_.arcs[index(a)];
    // One more than can flow: were it full, its ends' potentials could have either order.
    Number most = 1;
    for (const FlowArc& out : graph_.arcs) most += out.tail == graph_.source ? out.capacity : 0;
    return {graph_.sink, graph_.source, most, 0};
  }

  /// A StaticDigraph numbers its arcs in the order of their tails.
  void order_arcs() {
    order_.resize(graph_.arcs.size() + (graph_.source >= 0 ? 1 : 0));
    std::iota(order_.begin(), order_.end(), 0);
    std::vector<int> tail(order_.size());
    for (std::size_t a = 0; a < tail.size(); ++a) {
      tail[a] = a < graph_.arcs.size() ? graph_.arcs[a].tail : graph_.sink;
    }
    std::stable_sort(order_.begin(), order_.end(),
                     [&](int a, int b) { return tail[index(a)] < tail[index(b)]; });
  }

  const FlowGraph& graph_;
  std::vector<int> order_;  ///< of the arcs in digraph_
  Graph digraph_;
};

template <typename Code>
FlowResult solve(const FlowGraph& graph) {
  if (!fits_flow_codes(graph)) {
    FlowResult declined;
    declined.outcome = FlowOutcome::kDeclined;
    declined.reason = "its costs are too large for 64 bits";
    return declined;
  }
  return LemonGraph(graph).run<Code>();
}

}  // namespace

FlowResult network_simplex_flow(const FlowGraph& graph) {
  return solve<lemon::NetworkSimplex<Graph, Number, Number>>(graph);
}

FlowResult capacity_scaling_flow(const FlowGraph& graph) {
  return solve<lemon::CapacityScaling<Graph, Number, Number>>(graph);
}

FlowResult cost_scaling_flow(const FlowGraph& graph) {
  return solve<lemon::CostScaling<Graph, Number, Number>>(graph);
}

}  // namespace mda
