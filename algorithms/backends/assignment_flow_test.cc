#include "algorithms/backends/assignment_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/backends/junctions.h"
#include "algorithms/backends/lemon_flow.h"
#include "algorithms/testing/draw.h"
#include "algorithms/testing/random_flows.h"
#include "algorithms/testing/tracking_graphs.h"

namespace mda {
namespace {

TEST(AssignmentFlow, CostsTheSameInAnyOrderOfNodesAndArcs) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const FlowGraph graph = testing::random_path_flow(seed);
    const FlowGraph other = testing::reorder(graph, seed + 7);
    const FlowResult result = assignment_flow(graph);
    const FlowResult again = assignment_flow(other);
    ASSERT_EQ(result.outcome, again.outcome) << "seed " << seed;
    if (result.outcome != FlowOutcome::kOptimal) continue;
    ASSERT_EQ(flow_cost(graph, result.flow), flow_cost(other, again.flow)) << "seed " << seed;
  }
}

/// Small ones seldom make searches so long that the auction with the repair takes over.
TEST(AssignmentFlow, ProvesItsOptimumOnLargerGraphsOfEveryClass) {
  const std::vector<testing::TrackingShape> shapes = {
      {.scans = 30, .targets = 20, .clutter = 10, .side = 120.0},
      {.scans = 20, .targets = 15, .clutter = 5, .gate = 0.0, .reach = 1},
      {.scans = 30, .targets = 30, .mean_life = 4.0, .clutter = 10, .side = 120.0},
      {.scans = 30, .targets = 40, .clutter = 10, .side = 80.0},
      {.scans = 15, .clutter = 25, .reach = 1, .links = 0.0},
      {.scans = 40, .clutter = 25, .reach = 1, .links = 6.0, .whole_numbers = true},
      {.scans = 60,
       .clutter = 25,
       .reach = 1,
       .worst_link = 2.0,
       .end_cost = 10.0,
       .point_cost = -1.0},
  };
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const FlowGraph graph = testing::tracking_graph(shapes[s], seed);
      const FlowResult result = assignment_flow(graph);
      ASSERT_EQ(flow_fault(graph, result.flow), "") << "shape " << s << ", seed " << seed;
      const std::int64_t cost = flow_cost(graph, result.flow);
      ASSERT_EQ(certified_flow_bound(graph, result.potential), cost)
          << "shape " << s << ", seed " << seed;
      ASSERT_LT(cost, 0) << "shape " << s << " has no path worth taking";
    }
  }
}

TEST(AssignmentFlow, SolvesWindowsWithKnownTracks) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const FlowGraph graph =
        testing::window_graph(3 + static_cast<int>(seed % 4), 12, seed % 2 == 0, seed);
    const FlowResult result = assignment_flow(graph);
    ASSERT_EQ(flow_fault(graph, result.flow), "") << "seed " << seed;
    const std::int64_t cost = flow_cost(graph, result.flow);
    ASSERT_EQ(cost, flow_cost(graph, network_simplex_flow(graph).flow)) << "seed " << seed;
    ASSERT_EQ(certified_flow_bound(graph, result.potential), cost) << "seed " << seed;
  }
}

TEST(AssignmentFlow, SendsAllItCanPastTheDetections) {
  const FlowGraph graph{2, {0, 0}, {{0, 1, 5, -3}, {0, 1, 2, 4}, {0, 1, 0, -9}}, 0, 1};
  EXPECT_EQ(assignment_flow(graph).flow, (std::vector<std::int64_t>{5, 0, 0}));
}

/// Arcs of capacity 1 between any nodes, forward in time, so that many units may meet in a node.
FlowGraph random_junctions(std::uint64_t seed) {
  testing::Draw draw(seed);
  const int inner = 1 + draw.below(9);
  FlowGraph graph;
  graph.nodes = inner + 2;
  graph.supply.assign(static_cast<std::size_t>(graph.nodes), 0);
  graph.source = 0;
  graph.sink = graph.nodes - 1;
  for (int a = draw.below(5 * graph.nodes); a > 0; --a) {
    const int tail = draw.below(graph.nodes - 1);
    const int head = tail + 1 + draw.below(graph.nodes - 1 - tail);
    const std::int64_t cost = draw.below(seed % 2 == 0 ? 5 : 1000) - (seed % 2 == 0 ? 3 : 600);
    graph.arcs.push_back({tail, head, draw.chance(0.1) ? 0 : 1, cost});
  }
  return graph;
}

TEST(AssignmentFlow, TakesJunctionsApart) {
  int with_junctions = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    const FlowGraph plain = random_junctions(seed);
    const FlowGraph graph = seed % 3 == 0 ? testing::reorder(plain, seed) : plain;
    with_junctions += JunctionSplit(graph).has_junctions() ? 1 : 0;
    const FlowResult result = assignment_flow(graph);
    ASSERT_EQ(result.outcome, FlowOutcome::kOptimal) << "seed " << seed << ": " << result.reason;
    ASSERT_EQ(flow_fault(graph, result.flow), "") << "seed " << seed;
    const std::int64_t cost = flow_cost(graph, result.flow);
    ASSERT_EQ(cost, flow_cost(graph, network_simplex_flow(graph).flow)) << "seed " << seed;
    ASSERT_EQ(certified_flow_bound(graph, result.potential), cost) << "seed " << seed;
  }
  EXPECT_GT(with_junctions, 1500);
}

/// The reason of a refusal, with the node in brackets if it names one; empty if there was none.
std::string refusal(const FlowGraph& graph) {
  const FlowResult result = assignment_flow(graph);
  EXPECT_EQ(result.outcome == FlowOutcome::kDeclined, !result.reason.empty());
  EXPECT_TRUE(result.flow.empty() || result.reason.empty());
  if (result.reason_node < 0) return result.reason;
  return result.reason + " [" + std::to_string(result.reason_node) + "]";
}

FlowGraph free_flow(int nodes, std::vector<FlowArc> arcs) {
  return {nodes, std::vector<std::int64_t>(static_cast<std::size_t>(nodes)), std::move(arcs), 0, 1};
}

TEST(AssignmentFlow, DeclinesCycles) {
  // A closed chain, a cycle of two detections with a way in and out, and a node linked to itself.
  EXPECT_EQ(refusal(free_flow(4, {{2, 3, 1, -1}, {3, 2, 1, -1}})), "a node is on a cycle [2]");
  EXPECT_NE(refusal(free_flow(6, {{0, 2, 1, 0},
                                  {2, 3, 1, -1},
                                  {3, 4, 1, -1},
                                  {4, 5, 1, -1},
                                  {5, 2, 1, -1},
                                  {5, 1, 1, 0}}))
                .find("is on a cycle"),
            std::string::npos);
  EXPECT_EQ(refusal(free_flow(3, {{2, 2, 1, -1}, {2, 1, 1, -1}})), "a node is on a cycle [2]");
}

TEST(AssignmentFlow, NamesAJunctionOnACycleByItsOwnNumber) {
  // Two units may pass node 2, which is taken apart; the cycle leads through nothing else.
  EXPECT_EQ(refusal(free_flow(3, {{0, 2, 1, 0}, {2, 2, 1, -1}, {2, 1, 1, 0}})),
            "a node is on a cycle [2]");
}

TEST(AssignmentFlow, FindsNoCycleWhereNumbersRunAgainstTime) {
  EXPECT_EQ(refusal(free_flow(6, {{0, 4, 1, 0},
                                  {4, 5, 1, -1},
                                  {5, 2, 1, 0},
                                  {0, 2, 1, 3},
                                  {2, 3, 1, -1},
                                  {3, 1, 1, 0},
                                  {5, 1, 1, 0}})),
            "");
}

TEST(AssignmentFlow, DeclinesNodesThatAreNoDetections) {
  EXPECT_EQ(refusal(free_flow(3, {{0, 2, 2, 0}, {2, 1, 2, 0}})),
            "a node can carry more than one unit [2]");
  EXPECT_EQ(refusal(free_flow(3, {{0, 2, 1, 0}, {0, 2, 1, 1}, {2, 1, 1, 0}, {2, 1, 2, 2}})),
            "a node can carry more than one unit [2]");
  EXPECT_NE(refusal(free_flow(3, {{2, 0, 1, 0}})).find("[0]"), std::string::npos);
  EXPECT_NE(refusal(free_flow(3, {{1, 2, 1, 0}})).find("[1]"), std::string::npos);
  EXPECT_NE(refusal({2, {2, -2}, {{0, 1, 2, 0}}}).find("[0]"), std::string::npos);
  EXPECT_NE(refusal({3, {2, -1, -1}, {}}).find("[0]"), std::string::npos);
  EXPECT_NE(refusal({3, {1, 1, -2}, {{0, 1, 1, 0}, {1, 2, 1, 0}}}).find("[1]"), std::string::npos);
}

TEST(AssignmentFlow, DeclinesCostsOutOfRange) {
  for (const std::int64_t cost : {INT64_MIN, INT64_MAX, INT64_MAX / 256, -INT64_MAX / 256}) {
    EXPECT_NE(refusal(free_flow(3, {{0, 2, 1, cost}, {2, 1, 1, 0}})).find("too large"),
              std::string::npos);
  }
}

TEST(AssignmentFlow, IsExactWithTheLargestCosts) {
  const std::int64_t large = INT64_MAX / 128 / 8;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    FlowGraph graph = testing::random_path_flow(seed);
    std::int64_t most = 1;
    for (const FlowArc& arc : graph.arcs) most = std::max(most, std::abs(arc.cost));
    const std::int64_t factor = large / (graph.nodes + 1) / most;
    for (FlowArc& arc : graph.arcs) arc.cost *= factor;
    const FlowResult result = assignment_flow(graph);
    ASSERT_EQ(result.reason, "");
    if (result.outcome != FlowOutcome::kOptimal) continue;
    ASSERT_EQ(flow_fault(graph, result.flow), "");
    ASSERT_EQ(certified_flow_bound(graph, result.potential), flow_cost(graph, result.flow));
  }
}

}  // namespace
}  // namespace mda
