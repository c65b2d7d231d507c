#include "algorithms/tree/clusters.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_trees.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// With known tracks or births; every second with gates so narrow that there are several clusters.
AssociationProblem window(std::uint64_t seed) {
  TreeShape shape = random_tree_shape(seed, seed % 4 < 2);
  if (seed % 2 == 0) shape.gate_nats = -5.0;
  return random_tree_problem(shape, seed);
}

/// The rows of any column, left to themselves, and the worth of its leaf are its cost.
TEST(ClustersTest, WorthAndLeftoversAreTheCost) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = window(seed);
    const HypothesisTree& tree = problem.views()->tree;
    const Clusters clusters = clusters_of(problem);
    for (int n = 0; n < tree.nodes(); ++n) {
      const int column = tree.column[index(n)];
      if (column == kNoColumn) continue;
      double cost = clusters.worth[index(n)];
      for (const int r : problem.rows_of(column)) cost += clusters.leftover[index(r)].cost;
      EXPECT_NEAR(cost, problem.cost(column), tolerance(problem));
    }
  }
}

TEST(ClustersTest, EveryTreeIsInTheClusterOfItsColumns) {
  int several = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = window(seed);
    const HypothesisTree& tree = problem.views()->tree;
    const Clusters clusters = clusters_of(problem);
    std::vector<int> cluster(index(tree.nodes()), -1);
    for (int c = 0; c < clusters.size(); ++c) {
      for (std::size_t layer = 0; layer < clusters.roots[index(c)].size(); ++layer) {
        for (const int root : clusters.roots[index(c)][layer]) {
          EXPECT_EQ(cluster[index(root)], -1) << "listed twice";
          EXPECT_TRUE(root >= tree.layer_begin[layer] && root < tree.layer_begin[layer + 1]);
          cluster[index(root)] = c;
        }
      }
    }
    for (int n = 0; n < tree.nodes(); ++n) {
      if (tree.parent[index(n)] != kNoNode) {
        EXPECT_EQ(cluster[index(n)], -1) << "not a root";
        cluster[index(n)] = cluster[index(tree.parent[index(n)])];
      }
      if (tree.column[index(n)] == kNoColumn) continue;
      EXPECT_EQ(cluster[index(n)], problem.component_of_column()[index(tree.column[index(n)])]);
    }
    several += clusters.size() > 1 ? 1 : 0;
  }
  EXPECT_GE(several, 20);
}

}  // namespace
}  // namespace mda::testing
