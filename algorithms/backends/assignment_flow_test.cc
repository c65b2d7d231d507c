#include "algorithms/backends/assignment_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "algorithms/testing/random_flows.h"

namespace mda {
namespace {

constexpr std::uint64_t kGraphs = 2000;

TEST(AssignmentFlow, AlwaysProvesItsOptimum) {
  for (std::uint64_t seed = 1; seed <= kGraphs; ++seed) {
    const FlowGraph graph = testing::random_path_flow(seed);
    const FlowResult result = assignment_flow(graph);
    if (result.outcome != FlowOutcome::kOptimal) continue;
    ASSERT_EQ(result.potential.size(), static_cast<std::size_t>(graph.nodes));
  }
}

TEST(AssignmentFlow, CostsTheSameInAnyOrderOfNodesAndArcs) {
  for (std::uint64_t seed = 1; seed <= kGraphs; ++seed) {
    const FlowGraph graph = testing::random_path_flow(seed);
    const FlowGraph other = testing::reorder(graph, seed + 7);
    const FlowResult result = assignment_flow(graph);
    const FlowResult again = assignment_flow(other);
    ASSERT_EQ(result.outcome, again.outcome) << "seed " << seed;
    if (result.outcome != FlowOutcome::kOptimal) continue;
    ASSERT_EQ(flow_cost(graph, result.flow), flow_cost(other, again.flow)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace mda
