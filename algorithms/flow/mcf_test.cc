#include "algorithms/flow/mcf.h"

#include <gtest/gtest.h>

#include "algorithms/testing/contract.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_trees.h"

namespace mda {
namespace {

using testing::cost_of;
using testing::optimum;
using testing::random_tree_problem;
using testing::random_tree_shape;
using testing::row_violation;
using testing::tolerance;
using testing::TreeShape;

TreeShape shape_of(std::uint64_t seed) {
  TreeShape shape = random_tree_shape(seed, false);
  shape.must_go_on = seed % 2 == 0;
  return shape;
}

TEST(Mcf, IsExactForTwoScans) {
  const auto mcf = make_mcf();
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = shape_of(seed);
    shape.scans = 1 + static_cast<int>(seed % 4 / 2);
    const AssociationProblem problem = random_tree_problem(shape, seed);
    const Solution solution = mcf->solve(problem, Budget{});
    EXPECT_EQ(solution.stats.off_column_paths, 0);
    EXPECT_NEAR(cost_of(problem, solution), *optimum(problem), tolerance(problem));
  }
}

TEST(Mcf, TheRelaxationIsRoundedOnlyWhereFractional) {
  const auto mcf = make_mcf();
  const auto relaxed = make_mcf_lp();
  TreeShape crowded;
  crowded.tracks = 4;
  crowded.scans = 3;
  crowded.plots = 4;
  crowded.gate_nats = 4.0;
  crowded.history = 6.0;
  int fractional = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    crowded.must_go_on = seed % 2 == 0;
    const AssociationProblem problem = random_tree_problem(crowded, seed);
    const Solution a = mcf->solve(problem, Budget{});
    const Solution b = relaxed->solve(problem, Budget{});
    EXPECT_EQ(a.stats.lp_fractional, b.stats.lp_fractional);
    EXPECT_EQ(row_violation(problem, a), 0.0);
    EXPECT_EQ(row_violation(problem, b), 0.0);
    if (a.stats.lp_fractional == 0) {
      EXPECT_NEAR(cost_of(problem, a), cost_of(problem, b), tolerance(problem));
      continue;
    }
    ++fractional;
    testing::expect_order_does_not_matter(make_mcf_lp, problem,
                                          random_tree_problem(crowded, seed, 1));
  }
  EXPECT_GE(fractional, 10);
}

}  // namespace
}  // namespace mda
