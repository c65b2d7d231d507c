#include "algorithms/flow/scf_pairs.h"

#include <gtest/gtest.h>

#include "algorithms/flow/pair_graph.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_trees.h"

namespace mda {
namespace {

using testing::cost_of;
using testing::optimum;
using testing::random_tree_problem;
using testing::random_tree_shape;
using testing::tolerance;
using testing::TreeShape;

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Tracks are born, and there are no others.
TreeShape births(std::uint64_t seed) {
  TreeShape shape = random_tree_shape(seed, true);
  shape.births = true;
  shape.tracks = 0;
  return shape;
}

TEST(ScfPairs, IsExactForTwoScansOfBirths) {
  const auto pairs = make_scf_pairs();
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = births(seed);
    shape.scans = 2;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    const Solution solution = pairs->solve(problem, Budget{});
    EXPECT_EQ(solution.stats.off_column_paths, 0);
    EXPECT_NEAR(cost_of(problem, solution), *optimum(problem), tolerance(problem));
  }
}

/// A pair knows the last plot, and this window's costs depend on nothing before that.
TEST(ScfPairs, IsExactForBirthsWhenCostsDependOnTheLastPlotAlone) {
  const auto pairs = make_scf_pairs();
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = births(seed);
    shape.history = 0.0;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    const Solution solution = pairs->solve(problem, Budget{});
    EXPECT_EQ(solution.stats.off_column_paths, 0);
    EXPECT_NEAR(cost_of(problem, solution), *optimum(problem), tolerance(problem));
  }
}

TEST(PairGraph, ArcsOutOfABirthCostWhatTheirColumnsDo) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_tree_problem(births(seed), seed);
    const HypothesisTree& tree = problem.views()->tree;
    const PairGraph graph = pair_graph(problem);
    for (const PairArc& arc : graph.arcs) {
      const PairNode& tail = graph.nodes[index(arc.tail)];
      if (arc.head == PairArc::kEnd) continue;
      const PairNode& head = graph.nodes[index(arc.head)];
      EXPECT_LT(arc.tail, arc.head);
      EXPECT_EQ(head.before, tail.last);
      // The head's best partial path is the best over all its arcs.
      const double until_tail = tail.before == kNoRow ? 0.0 : tree.cost[index(tail.tree_node)];
      EXPECT_LE(tree.cost[index(head.tree_node)], until_tail + arc.cost + 1e-12);
    }
  }
}

}  // namespace
}  // namespace mda
