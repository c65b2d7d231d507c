#include "algorithms/backends/lemon_flow.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/backends/cbc.h"
#include "algorithms/testing/random_problems.h"

namespace mda {
namespace {

constexpr double kUnitsPerNat = 1 << 20;

/// A problem whose columns use at most one track and one plot, as a flow of one unit per row: from
/// the source through each track or plot that starts a column to the sink, or past all of them.
FlowGraph flow_of(const AssociationProblem& problem) {
  const int source = 2 * problem.rows();
  const int sink = source + 1;
  FlowGraph graph;
  graph.nodes = sink + 1;
  graph.supply.assign(static_cast<std::size_t>(graph.nodes), 0);
  graph.supply[static_cast<std::size_t>(source)] = problem.rows();
  graph.supply[static_cast<std::size_t>(sink)] = -problem.rows();
  graph.arcs.push_back({source, sink, problem.rows(), 0});
  for (int r = 0; r < problem.rows(); ++r) {
    // A row is an arc of capacity 1, so that it is used at most once: tracks are entered from the
    // source, plots left for the sink.
    graph.arcs.push_back({2 * r, 2 * r + 1, 1, 0});
    if (problem.dimension(r) == 0) {
      graph.arcs.push_back({source, 2 * r, 1, 0});
    } else {
      graph.arcs.push_back({2 * r + 1, sink, 1, 0});
    }
  }
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    const auto cost = static_cast<std::int64_t>(std::llround(problem.cost(j) * kUnitsPerNat));
    const bool has_track = problem.dimension(rows.front()) == 0;
    const bool has_plot = problem.dimension(rows.back()) != 0;
    const int tail = has_track ? 2 * rows.front() + 1 : source;
    const int head = has_plot ? 2 * rows.back() : sink;
    graph.arcs.push_back({tail, head, 1, cost});
  }
  return graph;
}

TEST(LemonFlow, FindsTheOptimumOfProblemsWithTwoDimensions) {
  CbcSolver branch_and_bound;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    testing::RandomShape shape;
    shape.dimensions = 2;
    shape.rows_per_dimension = 30;
    shape.columns = 300;
    const AssociationProblem problem = testing::random_problem(shape, seed);
    const FlowGraph graph = flow_of(problem);
    const std::vector<std::int64_t> flow = network_simplex_flow(graph).flow;
    ASSERT_EQ(flow.size(), graph.arcs.size());
    double cost = 0.0;
    for (std::size_t a = 0; a < flow.size(); ++a) {
      ASSERT_GE(flow[a], 0);
      ASSERT_LE(flow[a], graph.arcs[a].capacity);
      cost += static_cast<double>(flow[a] * graph.arcs[a].cost) / kUnitsPerNat;
    }
    const CbcResult optimum = branch_and_bound.solve(problem, {});
    ASSERT_EQ(optimum.outcome, Outcome::kOptimal);
    double optimal_cost = 0.0;
    for (const int j : optimum.chosen) optimal_cost += problem.cost(j);
    // Rounding moves the cost of each chosen column by half a unit at most.
    EXPECT_NEAR(cost, optimal_cost, 60 * 0.5 / kUnitsPerNat) << "seed " << seed;
  }
}

TEST(LemonFlow, KeepsFlowAtEveryNode) {
  testing::RandomShape shape;
  shape.dimensions = 2;
  shape.rows_per_dimension = 12;
  shape.columns = 60;
  const FlowGraph graph = flow_of(testing::random_problem(shape, 7));
  const std::vector<std::int64_t> flow = network_simplex_flow(graph).flow;
  std::vector<std::int64_t> left = graph.supply;
  for (std::size_t a = 0; a < flow.size(); ++a) {
    left[static_cast<std::size_t>(graph.arcs[a].tail)] -= flow[a];
    left[static_cast<std::size_t>(graph.arcs[a].head)] += flow[a];
  }
  for (const std::int64_t rest : left) EXPECT_EQ(rest, 0);
}

TEST(LemonFlow, SaysWhenSupplyCannotReachDemand) {
  const FlowGraph graph{2, {2, -2}, {{0, 1, 1, 3}}};
  EXPECT_TRUE(network_simplex_flow(graph).flow.empty());
}

}  // namespace
}  // namespace mda
