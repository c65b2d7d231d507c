#include "algorithms/flow/flow_codes.h"

#include <gtest/gtest.h>

#include "algorithms/testing/random_flows.h"

namespace mda {
namespace {

constexpr std::uint64_t kGraphs = 2000;

TEST(FlowCodes, AgreeOnTheOptimumOfGraphsOfAllKinds) {
  int infeasible = 0;
  for (std::uint64_t seed = 1; seed <= kGraphs; ++seed) {
    const FlowGraph graph = testing::random_path_flow(seed);
    const FlowResult reference = flow_codes().front().solve(graph);
    if (reference.outcome == FlowOutcome::kInfeasible) ++infeasible;
    for (const FlowCode& code : flow_codes()) {
      const FlowResult result = code.solve(graph);
      ASSERT_EQ(result.outcome, reference.outcome)
          << code.name << ", seed " << seed << ": " << result.reason;
      if (result.outcome != FlowOutcome::kOptimal) continue;
      ASSERT_EQ(flow_fault(graph, result.flow), "") << code.name << ", seed " << seed;
      const std::int64_t cost = flow_cost(graph, result.flow);
      ASSERT_EQ(cost, flow_cost(graph, reference.flow)) << code.name << ", seed " << seed;
      // Only the LP may fail to round its prices to a proof.
      if (code.name == "scf-lp" && result.potential.empty()) continue;
      ASSERT_EQ(certified_flow_bound(graph, result.potential), cost)
          << code.name << ", seed " << seed;
    }
  }
  EXPECT_GT(infeasible, static_cast<int>(kGraphs / 20));
  EXPECT_LT(infeasible, static_cast<int>(kGraphs / 2));
}

}  // namespace
}  // namespace mda
