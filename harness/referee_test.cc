#include "harness/referee.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/draw.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/tiny_problems.h"

namespace mda::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t kProblems = 300;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

AssociationProblem problem_of(std::uint64_t seed) {
  return random_problem(random_shape(seed, 24), seed);
}

/// The matrix written out: [row][column] is 1 where the column uses the row.
std::vector<std::vector<double>> dense(const AssociationProblem& problem) {
  std::vector<std::vector<double>> matrix(index(problem.rows()),
                                          std::vector<double>(index(problem.columns()), 0.0));
  for (int j = 0; j < problem.columns(); ++j) {
    for (const int r : problem.rows_of(j)) matrix[index(r)][index(j)] = 1.0;
  }
  return matrix;
}

/// A point of the unit cube: some values 0, some 1, some within the tolerance of them.
std::vector<double> random_point(const AssociationProblem& problem, Draw& draw) {
  std::vector<double> x(index(problem.columns()));
  for (double& value : x) {
    const double corner = draw.chance(0.3) ? 1.0 : 0.0;
    const double near = corner == 0.0 ? 1e-9 : 1.0 - 1e-9;
    value = draw.chance(0.3) ? draw.unit() : draw.chance(0.2) ? near : corner;
  }
  return x;
}

bool far_from_whole(double value) { return std::abs(value - std::round(value)) > 1e-6; }

TEST(RefereeTest, ExaminesAsTheDenseMatrixSays) {
  for (std::uint64_t seed = 1; seed <= kProblems; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = problem_of(seed);
    Draw draw(seed);
    const std::vector<double> x = random_point(problem, draw);
    double cost = 0.0;
    int fractional = 0;
    for (int j = 0; j < problem.columns(); ++j) {
      cost += problem.cost(j) * x[index(j)];
      fractional += far_from_whole(x[index(j)]) ? 1 : 0;
    }
    double violation = 0.0;
    int fractional_slacks = 0;
    const auto matrix = dense(problem);
    for (int r = 0; r < problem.rows(); ++r) {
      double use = 0.0;
      for (int j = 0; j < problem.columns(); ++j) use += matrix[index(r)][index(j)] * x[index(j)];
      violation = std::max(violation, use - 1.0);
      if (problem.use(r) == RowUse::kExactlyOnce) violation = std::max(violation, 1.0 - use);
      if (problem.dimension(r) > 0 && far_from_whole(1.0 - use)) ++fractional_slacks;
    }
    const Examination examined = examine(problem, x);
    ASSERT_TRUE(examined.well_formed);
    EXPECT_NEAR(examined.cost, cost, 1e-9);
    EXPECT_NEAR(examined.row_violation, violation, 1e-12);
    EXPECT_EQ(examined.fractional, fractional);
    EXPECT_EQ(examined.paper_fractional, fractional + fractional_slacks);
    EXPECT_EQ(examined.feasible(), violation <= 1e-6);
    EXPECT_EQ(examined.is_choice(), violation <= 1e-6 && fractional == 0);
  }
}

TEST(RefereeTest, RefusesPointsThatAreNone) {
  const AssociationProblem problem = problem_of(3);
  const std::vector<double> good(index(problem.columns()), 0.0);
  EXPECT_TRUE(examine(problem, good).well_formed);
  for (const double bad : {kNaN, kInfinity, -kInfinity, -1e-6, 1.0 + 1e-6, 2.0}) {
    for (std::size_t j = 0; j < good.size(); ++j) {
      std::vector<double> x = good;
      x[j] = bad;
      EXPECT_FALSE(examine(problem, x).well_formed) << bad << " at " << j;
      EXPECT_FALSE(examine(problem, x).feasible());
      EXPECT_FALSE(examine(problem, x).is_choice());
    }
  }
  EXPECT_FALSE(examine(problem, std::vector<double>(good.size() - 1)).well_formed);
  EXPECT_FALSE(examine(problem, std::vector<double>(good.size() + 1)).well_formed);
  EXPECT_FALSE(examine(problem, {}).well_formed);
  EXPECT_TRUE(examine(AssociationProblem(), {}).is_choice());
}

/// L(u) from the dense matrix.
double dense_bound(const AssociationProblem& problem, const std::vector<double>& u) {
  const auto matrix = dense(problem);
  double bound = 0.0;
  for (const double multiplier : u) bound -= multiplier;
  for (int j = 0; j < problem.columns(); ++j) {
    double reduced = problem.cost(j);
    for (int r = 0; r < problem.rows(); ++r) reduced += matrix[index(r)][index(j)] * u[index(r)];
    bound += std::min(0.0, reduced);
  }
  return bound;
}

TEST(RefereeTest, CertifiesNoMoreThanIsTrue) {
  const CatalogEntry* brute_force = find_algorithm("brute-force");
  ASSERT_NE(brute_force, nullptr);
  const auto solver = brute_force->make();
  int near = 0;
  for (std::uint64_t seed = 1; seed <= kProblems; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = problem_of(seed);
    const Solution best = solver->solve(problem, Budget{});
    const double optimum =
        best.status == Status::kOptimal ? examine(problem, best.x).cost : kInfinity;
    Draw draw(seed);
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<double> u(index(problem.rows()));
      for (double& multiplier : u) multiplier = draw.chance(0.2) ? 0.0 : 14.0 * draw.unit() - 4.0;
      const auto bound = certified_bound(problem, u);
      for (int r = 0; r < problem.rows(); ++r) {
        if (problem.use(r) == RowUse::kAtMostOnce) u[index(r)] = std::max(0.0, u[index(r)]);
      }
      ASSERT_TRUE(bound);
      EXPECT_LE(*bound, optimum);
      EXPECT_LE(*bound, dense_bound(problem, u));
      EXPECT_NEAR(*bound, dense_bound(problem, u), 1e-6);
      if (*bound > optimum - 1.0) ++near;
    }
  }
  EXPECT_GT(near, 0) << "bounds this loose would hide a mistake";
}

TEST(RefereeTest, CertifiesTheLpValueFromTheLpPrices) {
  const auto lp = find_algorithm("lp")->make();
  std::uint64_t certified = 0;
  for (std::uint64_t seed = 1; seed <= kProblems; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = problem_of(seed);
    if (!lp->can_solve(problem.shape()).ok) continue;
    const Solution solution = lp->solve(problem, Budget{});
    if (solution.status == Status::kNoAnswer) continue;  // nothing fills the exactly-once rows
    const auto bound = certified_bound(problem, solution.row_dual);
    ASSERT_TRUE(bound);
    EXPECT_NEAR(*bound, examine(problem, solution.x).cost, 1e-5);
    ++certified;
  }
  EXPECT_GT(certified, kProblems / 2);
}

TEST(RefereeTest, CertifiesNothingFromWhatAreNoMultipliers) {
  const AssociationProblem problem = problem_of(5);
  const std::vector<double> good(index(problem.rows()), 1.0);
  EXPECT_TRUE(certified_bound(problem, good));
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    std::vector<double> u = good;
    u.back() = bad;
    EXPECT_FALSE(certified_bound(problem, u)) << bad;
  }
  EXPECT_FALSE(certified_bound(problem, std::vector<double>(good.size() - 1, 1.0)));
  EXPECT_FALSE(certified_bound(problem, std::vector<double>(good.size() + 1, 1.0)));
  EXPECT_FALSE(certified_bound(problem, {}));
}

/// Two rows; the best is column 2 alone (-5), then columns 0 and 1 together (-4).
AssociationProblem two_or_one() {
  ProblemBuilder builder;
  for (const int dimension : {1, 2}) builder.add_row(dimension, RowUse::kAtMostOnce);
  builder.add_column(-2.0, std::vector<int>{0});
  builder.add_column(-2.0, std::vector<int>{1});
  builder.add_column(-5.0, std::vector<int>{0, 1});
  return builder.build();
}

std::string why_refuted(const Solution& solution, double best = -5.0) {
  return refutation(solution, examine(two_or_one(), solution.x), Knowledge{best});
}

Solution claim(Status status, std::vector<double> x, Answer answer = Answer::kSelection) {
  Solution solution;
  solution.status = status;
  solution.answer = answer;
  solution.x = std::move(x);
  return solution;
}

TEST(RefereeTest, BelievesWhatIsTrue) {
  EXPECT_EQ(why_refuted(claim(Status::kOptimal, {0, 0, 1})), "");
  EXPECT_EQ(why_refuted(claim(Status::kFeasible, {1, 1, 0})), "");
  EXPECT_EQ(why_refuted(claim(Status::kFeasible, {0, 0, 0})), "");
  EXPECT_EQ(why_refuted(claim(Status::kOptimal, {0, 0, 1}, Answer::kRelaxation)), "");
  EXPECT_EQ(why_refuted(claim(Status::kFeasible, {0.5, 0.5, 0.5}, Answer::kRelaxation)), "");
  EXPECT_EQ(why_refuted(claim(Status::kFeasible, {1, 1, 1}, Answer::kMarginals)), "");
  EXPECT_EQ(why_refuted(claim(Status::kNoAnswer, {})), "");
  Solution bounded = claim(Status::kOptimal, {0, 0, 1});
  for (const double bound : {-kInfinity, -6.0, -5.0, -5.0 + 1e-6}) {
    bounded.lower_bound = bound;
    EXPECT_EQ(why_refuted(bounded), "") << bound;
  }
}

TEST(RefereeTest, RefutesEveryKindOfLie) {
  const auto expect_refuted = [](const Solution& solution, const char* word) {
    EXPECT_NE(why_refuted(solution).find(word), std::string::npos) << why_refuted(solution);
  };
  expect_refuted(claim(Status::kFeasible, {1, 0, 1}), "row is broken");
  expect_refuted(claim(Status::kFeasible, {0.6, 0, 0.6}, Answer::kRelaxation), "row is broken");
  expect_refuted(claim(Status::kFeasible, {0.5, 0.5, 0.5}), "neither used nor unused");
  expect_refuted(claim(Status::kOptimal, {1, 1, 0}), "but -5 is known");
  expect_refuted(claim(Status::kOptimal, {1, 1, 0}, Answer::kRelaxation), "but -5 is known");
  expect_refuted(claim(Status::kFeasible, {0, 1}), "per column");
  expect_refuted(claim(Status::kFeasible, {0, 0, 0, 1}), "per column");
  expect_refuted(claim(Status::kOptimal, {}), "per column");
  expect_refuted(claim(Status::kFeasible, {0, kNaN, 0}), "per column");
  expect_refuted(claim(Status::kFeasible, {0, -1, 0}, Answer::kMarginals), "per column");
  for (const Status status : {Status::kOptimal, Status::kFeasible, Status::kNoAnswer}) {
    Solution bounded = claim(status, {0, 0, 1});
    for (const double bound : {-4.999, 0.0, kInfinity}) {
      bounded.lower_bound = bound;
      expect_refuted(bounded, "claimed the bound");
    }
    bounded.lower_bound = kNaN;
    expect_refuted(bounded, "not a number");
  }
}

TEST(RefereeTest, AnUnfilledExactlyOnceRowIsBroken) {
  const AssociationProblem& problem = tiny_problem("nothing fills it").problem;
  const std::vector<double> nothing(index(problem.columns()), 0.0);
  EXPECT_EQ(examine(problem, nothing).row_violation, 1.0);
  EXPECT_FALSE(examine(problem, nothing).feasible());
}

TEST(RefereeTest, ToleranceGrowsWithTheCost) {
  EXPECT_EQ(cost_tolerance(0.0), 1e-5);
  EXPECT_EQ(cost_tolerance(-1e6), 1e-5 + 1e-3);
  EXPECT_EQ(cost_tolerance(1e6), cost_tolerance(-1e6));
}

}  // namespace
}  // namespace mda::testing
