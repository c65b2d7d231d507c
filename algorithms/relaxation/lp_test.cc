#include "algorithms/relaxation/lp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/relaxation/lp_grp.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/tiny_problems.h"

namespace mda::testing {
namespace {

TEST(LpTest, ReachesTheKnownValues) {
  const auto lp = make_lp();
  for (const TinyProblem& tiny : tiny_problems()) {
    SCOPED_TRACE(tiny.name);
    const Solution solution = lp->solve(tiny.problem, Budget{});
    EXPECT_EQ(solution.status == Status::kOptimal, tiny.lp_value.has_value());
    if (!tiny.lp_value.has_value()) continue;
    EXPECT_NEAR(solution.lower_bound, *tiny.lp_value, 1e-9);
    EXPECT_NEAR(cost_of(tiny.problem, solution.x), *tiny.lp_value, 1e-9);
  }
}

bool integral(const std::vector<double>& x) {
  return std::all_of(x.begin(), x.end(),
                     [](double value) { return std::min(value, 1.0 - value) <= 1e-6; });
}

TEST(LpGrpTest, ClaimsAnOptimumJustWhenTheRelaxationIsIntegral) {
  const auto lp_grp = make_lp_grp();
  int fractional = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_problem(random_shape(seed, 60), seed);
    if (!lp_grp->can_solve(problem.shape()).ok) continue;
    const Solution solution = lp_grp->solve(problem, Budget{});
    ASSERT_EQ(solution.relaxation.size(), solution.x.size());
    EXPECT_EQ(solution.status,
              integral(solution.relaxation) ? Status::kOptimal : Status::kFeasible);
    if (!integral(solution.relaxation)) ++fractional;
  }
  EXPECT_GE(fractional, 20) << "the problems are too easy to test the rounding";
}

TEST(LpGrpTest, DeclinesWhatItCannotPromiseToFill) {
  const auto lp_grp = make_lp_grp();
  EXPECT_FALSE(lp_grp->can_solve(tiny_problem("one plot for two").problem.shape()).ok);
  EXPECT_TRUE(lp_grp->can_solve(tiny_problem("must go on").problem.shape()).ok);
}

}  // namespace
}  // namespace mda::testing
