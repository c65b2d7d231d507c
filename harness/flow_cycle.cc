#include "harness/flow_cycle.h"

#include <algorithm>
#include <vector>

namespace mda {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Arcs grouped by tail: those of node n are arcs[first[n]] to arcs[first[n + 1] - 1].
struct OutArcs {
  std::vector<std::size_t> first;
  std::vector<std::size_t> arcs;
};

OutArcs out_arcs(const FlowGraph& graph) {
  OutArcs out;
  out.first.assign(index(graph.nodes) + 1, 0);
  for (const FlowArc& arc : graph.arcs) ++out.first[index(arc.tail) + 1];
  for (std::size_t n = 0; n < index(graph.nodes); ++n) out.first[n + 1] += out.first[n];
  out.arcs.resize(graph.arcs.size());
  std::vector<std::size_t> next = out.first;
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    out.arcs[next[index(graph.arcs[a].tail)]++] = a;
  }
  return out;
}

/// Per node, how many of its incoming arcs are left after nodes without any were taken away, with
/// their arcs, as long as there were any: 0 everywhere if the graph has no cycle.
std::vector<int> arcs_left_in(const FlowGraph& graph) {
  const OutArcs out = out_arcs(graph);
  std::vector<int> left(index(graph.nodes), 0);
  for (const FlowArc& arc : graph.arcs) ++left[index(arc.head)];
  std::vector<int> ready;
  for (int n = 0; n < graph.nodes; ++n) {
    if (left[index(n)] == 0) ready.push_back(n);
  }
  while (!ready.empty()) {
    const std::size_t node = index(ready.back());
    ready.pop_back();
    for (std::size_t i = out.first[node]; i < out.first[node + 1]; ++i) {
      const int head = graph.arcs[out.arcs[i]].head;
      if (--left[index(head)] == 0) ready.push_back(head);
    }
  }
  return left;
}

}  // namespace

std::optional<std::size_t> arc_that_closes_a_cycle(const FlowGraph& graph) {
  const std::vector<int> left = arcs_left_in(graph);
  const auto is_left = [&](int node) { return left[index(node)] > 0; };
  std::vector<std::size_t> arc_into(index(graph.nodes));
  int node = -1;
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    if (!is_left(graph.arcs[a].tail) || !is_left(graph.arcs[a].head)) continue;
    node = graph.arcs[a].head;
    arc_into[index(node)] = a;
  }
  if (node < 0) return std::nullopt;
  // Every node that is left can be entered from another one, so going backwards never ends; after
  // as many steps as there are nodes it goes round a cycle.
  for (int step = 0; step < graph.nodes; ++step) node = graph.arcs[arc_into[index(node)]].tail;
  const int start = node;
  std::size_t last = 0;
  do {
    last = std::max(last, arc_into[index(node)]);
    node = graph.arcs[arc_into[index(node)]].tail;
  } while (node != start);
  return last;
}

}  // namespace mda
