#include "algorithms/exact/exact.h"

#include <gtest/gtest.h>

#include "algorithms/exact/branch_and_bound.h"
#include "algorithms/exact/brute_force.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/tiny_problems.h"

namespace mda::testing {
namespace {

/// Too large for the oracle, in several components, many of them fractional.
AssociationProblem window_like_problem(std::uint64_t seed) {
  RandomShape shape;
  shape.dimensions = 4;
  shape.rows_per_dimension = 15;
  shape.columns = 120;
  shape.presence = 0.6;
  shape.neighbourhood = 3;
  shape.exactly_once = seed % 2 == 0 ? 0.2 : 0.0;
  return random_problem(shape, seed);
}

TEST(ExactTest, AgreesWithBranchAndBoundOnTheWholeProblem) {
  const auto exact = make_exact();
  const auto whole = make_branch_and_bound();
  int searched = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = window_like_problem(seed);
    const Solution a = exact->solve(problem, Budget{});
    const Solution b = whole->solve(problem, Budget{});
    ASSERT_EQ(a.status, Status::kOptimal);
    ASSERT_EQ(b.status, Status::kOptimal);
    EXPECT_EQ(row_violation(problem, a.x), 0.0);
    EXPECT_NEAR(cost_of(problem, a.x), cost_of(problem, b.x), tolerance(problem));
    EXPECT_LE(certified_bound(problem, a.row_dual), a.lower_bound + tolerance(problem));
    if (certified_bound(problem, a.row_dual) < a.lower_bound - 1e-3) ++searched;
  }
  EXPECT_GE(searched, 10) << "the relaxations are too often integral to test the search";
}

TEST(BruteForceTest, DeclinesMoreThan25Columns) {
  RandomShape shape;
  shape.columns = 25;
  EXPECT_TRUE(make_brute_force()->can_solve(random_problem(shape, 1).shape()).ok);
  shape.columns = 26;
  const Verdict verdict = make_brute_force()->can_solve(random_problem(shape, 1).shape());
  EXPECT_FALSE(verdict.ok);
  EXPECT_NE(verdict.reason.find("26"), std::string::npos);
}

TEST(BruteForceTest, FindsOutThatNothingFillsTheRows) {
  for (const char* name : {"one plot for two", "triangle that must", "nothing fills it"}) {
    EXPECT_EQ(make_brute_force()->solve(tiny_problem(name).problem, Budget{}).status,
              Status::kNoAnswer);
  }
}

}  // namespace
}  // namespace mda::testing
