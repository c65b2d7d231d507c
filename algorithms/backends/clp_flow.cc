#include "algorithms/backends/clp_flow.h"

#include <ClpSimplex.hpp>
#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "algorithms/backends/clp.h"

namespace mda {
namespace {

/// Two entries per arc: what leaves the tail less what enters the head is a node's supply. An arc
/// from a node to itself changes no node.
struct Incidence {
  std::vector<CoinBigIndex> begins = {0};
  std::vector<int> rows;
  std::vector<double> entries;
  std::vector<double> capacity;
  std::vector<double> cost;

  void add(int tail, int head, double arc_capacity, double arc_cost) {
    if (tail != head) {
      rows.insert(rows.end(), {tail, head});
      entries.insert(entries.end(), {1.0, -1.0});
    }
    begins.push_back(static_cast<CoinBigIndex>(rows.size()));
    capacity.push_back(arc_capacity);
    cost.push_back(arc_cost);
  }
};

/// A free amount of flow becomes a circulation, by a return arc as the last column.
Incidence incidence_of(const FlowGraph& graph) {
  Incidence lp;
  for (const FlowArc& arc : graph.arcs) {
    lp.add(arc.tail, arc.head, static_cast<double>(arc.capacity), static_cast<double>(arc.cost));
  }
  if (graph.source >= 0) lp.add(graph.sink, graph.source, COIN_DBL_MAX, 0.0);
  return lp;
}

void load(const FlowGraph& graph, ClpSimplex& model) {
  const Incidence lp = incidence_of(graph);
  const std::vector<double> supply(graph.supply.begin(), graph.supply.end());
  model.setLogLevel(0);
  model.loadProblem(static_cast<int>(lp.cost.size()), graph.nodes, lp.begins.data(), lp.rows.data(),
                    lp.entries.data(), nullptr, lp.capacity.data(), lp.cost.data(), supply.data(),
                    supply.data());
}

std::vector<std::int64_t> integral_flow(std::span<const double> x) {
  std::vector<std::int64_t> flow;
  flow.reserve(x.size());
  for (std::size_t a = 0; a < x.size(); ++a) {
    if (!is_integral(x[a])) {
      throw std::runtime_error("Clp's flow on arc " + std::to_string(a) +
                               " is not integral: " + std::to_string(x[a]));
    }
    flow.push_back(std::llround(x[a]));
  }
  return flow;
}

/// Clp's row price is the change of the optimum per unit of supply, which is -y.
std::vector<std::int64_t> certificate(const FlowGraph& graph, std::span<const double> row_price,
                                      std::int64_t cost) {
  constexpr double kExactIntegers = 0x1.0p53;
  std::vector<std::int64_t> potential;
  potential.reserve(row_price.size());
  for (const double price : row_price) {
    if (std::abs(price) > kExactIntegers) return {};
    potential.push_back(-std::llround(price));
  }
  if (certified_flow_bound(graph, potential) != cost) potential.clear();
  return potential;
}

/// Whether the sums that Clp forms of costs, and of flows, stay exact.
bool is_exact_in_doubles(const FlowGraph& graph) {
  constexpr double kExactIntegers = 0x1.0p53;
  double costs = 0.0;
  double capacities = 0.0;
  for (const FlowArc& arc : graph.arcs) {
    costs = std::max(costs, std::abs(static_cast<double>(arc.cost)));
    capacities += static_cast<double>(arc.capacity);
  }
  return costs * (graph.nodes + 1) < kExactIntegers && capacities < kExactIntegers;
}

}  // namespace

FlowResult clp_flow(const FlowGraph& graph) {
  FlowResult result;
  if (!is_exact_in_doubles(graph)) {
    result.outcome = FlowOutcome::kDeclined;
    result.reason = "its costs or capacities are too large for a code that works with doubles";
    return result;
  }
  ClpSimplex model;
  load(graph, model);
  model.dual();
  constexpr int kClpInfeasible = 1;
  if (model.status() == kClpInfeasible) return result;
  if (!model.isProvenOptimal()) {
    throw std::runtime_error("Clp gave up with status " + std::to_string(model.status()));
  }
  result.flow = integral_flow({model.primalColumnSolution(), graph.arcs.size()});
  result.lp_fractional = 0;
  result.outcome = FlowOutcome::kOptimal;
  result.potential = certificate(graph, {model.dualRowSolution(), graph.supply.size()},
                                 flow_cost(graph, result.flow));
  return result;
}

}  // namespace mda
