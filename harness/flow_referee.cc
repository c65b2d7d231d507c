#include "harness/flow_referee.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mda {
namespace {

constexpr double kRoundingMargin = 1e-9;  ///< of the bound's size

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Summed from the smallest cost on, so that the order of the lines does not matter.
double cost_of(const FlowFile& file, const std::vector<std::int64_t>& flow) {
  std::vector<double> costs;
  for (std::size_t a = 0; a < flow.size(); ++a) {
    const std::int64_t units = flow[a] + file.lower[a];
    if (units != 0) costs.push_back(file.cost[a] * static_cast<double>(units));
  }
  std::sort(costs.begin(), costs.end());
  double sum = 0.0;
  for (const double cost : costs) sum += cost;
  return sum;
}

std::int64_t paths_of(const FlowFile& file, const std::vector<std::int64_t>& flow) {
  if (!file.is_tracking()) return file.supplied;
  std::int64_t out = 0;
  for (std::size_t a = 0; a < flow.size(); ++a) {
    if (file.graph.arcs[a].tail == file.graph.source) out += flow[a];
  }
  return out;
}

/// The certificate of FlowResult::potential with the file's own costs, which the graph's have been
/// rounded from. A long double holds any potential.
double bound_from_own_costs(const FlowFile& file, const std::vector<std::int64_t>& potential) {
  const auto y = [&](int node) { return static_cast<long double>(potential[index(node)]); };
  long double bound = 0.0L;
  for (std::size_t a = 0; a < file.cost.size(); ++a) {
    const FlowArc& arc = file.graph.arcs[a];
    const long double difference = (y(arc.tail) - y(arc.head)) / file.cost_scale;
    const long double reduced_cost = file.cost[a] + difference;
    if (reduced_cost < 0.0L) bound += static_cast<long double>(arc.capacity) * reduced_cost;
  }
  // All terms are negative, so that the bound's size is the sum of theirs.
  return static_cast<double>(bound * (1.0L + kRoundingMargin));
}

/// In units of the file, from the bound on the graph.
double certified_bound(const FlowFile& file, const FlowResult& result, std::int64_t bound) {
  if (file.is_tracking()) return bound_from_own_costs(file, result.potential);
  const std::vector<std::int64_t> no_flow(file.graph.arcs.size(), 0);
  return static_cast<double>(bound) + cost_of(file, no_flow);
}

std::string refutation_of_infeasibility(const FlowGraph& graph) {
  const bool is_feasible = std::all_of(graph.supply.begin(), graph.supply.end(),
                                       [](std::int64_t supply) { return supply == 0; });
  return is_feasible ? "it finds the graph infeasible, but no flow at all is a flow" : "";
}

std::string refutation_of_optimum(std::int64_t cost, const std::vector<std::int64_t>& potential,
                                  const std::optional<std::int64_t>& bound) {
  if (potential.empty() || bound == cost) return {};
  if (!bound) return "its potentials certify no bound";
  return fmt::format("its potentials certify {}, but its flow costs {}, in the units it was given",
                     *bound, cost);
}

}  // namespace

FlowVerdict judge_flow(const FlowFile& file, const FlowResult& result) {
  FlowVerdict verdict;
  const auto bound = certified_flow_bound(file.graph, result.potential);
  if (bound) verdict.certified_bound = certified_bound(file, result, *bound);
  if (result.outcome == FlowOutcome::kInfeasible) {
    verdict.refutation = refutation_of_infeasibility(file.graph);
  }
  if (result.outcome != FlowOutcome::kOptimal) return verdict;
  verdict.refutation = flow_fault(file.graph, result.flow);
  if (!verdict.refutation.empty()) return verdict;
  verdict.cost = cost_of(file, result.flow);
  verdict.paths = paths_of(file, result.flow);
  verdict.refutation =
      refutation_of_optimum(flow_cost(file.graph, result.flow), result.potential, bound);
  return verdict;
}

}  // namespace mda
