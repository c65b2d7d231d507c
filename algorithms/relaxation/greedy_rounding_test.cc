#include "algorithms/relaxation/greedy_rounding.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "algorithms/testing/draw.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/tiny_problems.h"

namespace mda::testing {
namespace {

std::vector<double> as_point(const std::vector<int>& columns, int count) {
  std::vector<double> x(static_cast<std::size_t>(count), 0.0);
  for (const int j : columns) x[static_cast<std::size_t>(j)] = 1.0;
  return x;
}

/// Any values at all, among them many that tie.
std::vector<double> random_point(int count, std::uint64_t seed) {
  Draw draw(seed);
  std::vector<double> x(static_cast<std::size_t>(count));
  for (double& value : x) value = draw.chance(0.5) ? 0.25 * draw.below(5) : draw.unit();
  return x;
}

AssociationProblem always_feasible_problem(std::uint64_t seed) {
  RandomShape shape = random_shape(seed, 60);
  shape.lone_columns = true;
  return random_problem(shape, seed);
}

/// The paper's loop as it stands, without thought for speed.
std::vector<int> literal_rounding(const AssociationProblem& problem, const std::vector<double>& x) {
  std::vector<char> used(static_cast<std::size_t>(problem.rows()), 0);
  const auto eligible = [&](int z) {
    bool fills = false;
    for (const int r : problem.rows_of(z)) {
      if (used[static_cast<std::size_t>(r)] != 0) return false;
      fills = fills || problem.use(r) == RowUse::kExactlyOnce;
    }
    return fills || problem.cost(z) < 0.0;
  };
  std::vector<int> chosen;
  while (true) {
    double largest = -1.0;
    for (int z = 0; z < problem.columns(); ++z) {
      if (eligible(z)) largest = std::max(largest, x[static_cast<std::size_t>(z)]);
    }
    int best = -1;
    for (int z = 0; z < problem.columns(); ++z) {
      if (!eligible(z) || x[static_cast<std::size_t>(z)] < largest - kRoundingTie) continue;
      if (best < 0 || problem.cost(z) < problem.cost(best)) best = z;
    }
    if (best < 0) break;
    chosen.push_back(best);
    for (const int r : problem.rows_of(best)) used[static_cast<std::size_t>(r)] = 1;
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

RC_GTEST_PROP(GreedyRoundingTest, IsThePapersLoop, (std::uint64_t seed)) {
  const AssociationProblem problem = always_feasible_problem(seed);
  const std::vector<double> x = random_point(problem.columns(), seed);
  RC_ASSERT(greedy_rounding(problem, x) == literal_rounding(problem, x));
}

RC_GTEST_PROP(GreedyRoundingTest, BreaksNoRow, (std::uint64_t seed)) {
  const AssociationProblem problem = always_feasible_problem(seed);
  const auto chosen = greedy_rounding(problem, random_point(problem.columns(), seed));
  RC_ASSERT(row_violation(problem, as_point(chosen, problem.columns())) == 0.0);
}

RC_GTEST_PROP(GreedyRoundingTest, LeavesNothingWorthTaking, (std::uint64_t seed)) {
  const AssociationProblem problem = always_feasible_problem(seed);
  const auto chosen = greedy_rounding(problem, random_point(problem.columns(), seed));
  for (int j = 0; j < problem.columns(); ++j) {
    std::vector<double> x = as_point(chosen, problem.columns());
    if (problem.cost(j) >= 0.0 || x[static_cast<std::size_t>(j)] == 1.0) continue;
    x[static_cast<std::size_t>(j)] = 1.0;
    RC_ASSERT(row_violation(problem, x) > 0.0);
  }
}

RC_GTEST_PROP(GreedyRoundingTest, KeepsAnIntegralChoice, (std::uint64_t seed)) {
  const AssociationProblem problem = always_feasible_problem(seed);
  const auto chosen = greedy_rounding(problem, random_point(problem.columns(), seed));
  RC_ASSERT(greedy_rounding(problem, as_point(chosen, problem.columns())) == chosen);
}

/// The largest value first, of tied ones the cheapest, of equally cheap ones the first.
///
///     column  cost  x     rows
///     0       -1    0.6   p q
///     1       -9    0.4   q r
///     2       -4    0.4   r s
///     3       -4    0.4+  r t      (ties with 2: closer than 1e-9)
///     4       -2    0     t
///     5       +1    0     s        (would only cost)
TEST(GreedyRoundingTest, FollowsTheTieRule) {
  ProblemBuilder builder;
  for (int scan = 1; scan <= 5; ++scan) builder.add_row(scan, RowUse::kAtMostOnce);
  const int p = 0;
  const int q = 1;
  const int r = 2;
  const int s = 3;
  const int t = 4;
  builder.add_column(-1.0, std::vector{p, q});
  builder.add_column(-9.0, std::vector{q, r});
  builder.add_column(-4.0, std::vector{r, s});
  builder.add_column(-4.0, std::vector{r, t});
  builder.add_column(-2.0, std::vector{t});
  builder.add_column(1.0, std::vector{s});
  const std::vector<double> x = {0.6, 0.4, 0.4, 0.4 + 1e-10, 0.0, 0.0};
  EXPECT_EQ(greedy_rounding(builder.build(), x), (std::vector{0, 2, 4}));
}

TEST(GreedyRoundingTest, RoundsTheTriangleToItsBestSide) {
  const std::vector<double> halves = {0.5, 0.5, 0.5};
  EXPECT_EQ(greedy_rounding(tiny_problem("lopsided triangle").problem, halves), std::vector{2});
  EXPECT_EQ(greedy_rounding(tiny_problem("triangle").problem, halves), std::vector{0});
}

TEST(GreedyRoundingTest, FillsAnExactlyOnceRowAtACost) {
  const std::vector<double> nothing = {0.0, 0.0};
  EXPECT_EQ(greedy_rounding(tiny_problem("must go on").problem, nothing), std::vector{1});
}

}  // namespace
}  // namespace mda::testing
