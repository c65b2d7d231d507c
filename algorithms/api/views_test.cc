#include "algorithms/api/views.h"

#include <gtest/gtest.h>

#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_trees.h"
#include "algorithms/testing/tree_laws.h"

namespace mda::testing {
namespace {

TEST(HypothesisTree, RandomTreesObeyItsLaws) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    for (const std::uint64_t order : {0, 5}) {
      expect_lawful_tree(random_tree_problem(random_tree_shape(seed, seed % 2 == 0), seed, order));
    }
  }
}

TEST(HypothesisTree, AnotherOrderIsTheSameProblem) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const TreeShape shape = random_tree_shape(seed, seed % 2 == 0);
    const AssociationProblem plain = random_tree_problem(shape, seed);
    const AssociationProblem other = random_tree_problem(shape, seed, 3);
    ASSERT_EQ(plain.columns(), other.columns());
    EXPECT_NEAR(*optimum(plain), *optimum(other), 1e-9);
  }
}

TEST(HypothesisTree, TupleCostIsTheColumnsCost) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_tree_problem(random_tree_shape(seed, false), seed, 2);
    ASSERT_TRUE(problem.views()->tuple_cost);
    expect_tuple_cost_of_columns(problem, 1e-9);
  }
}

}  // namespace
}  // namespace mda::testing
