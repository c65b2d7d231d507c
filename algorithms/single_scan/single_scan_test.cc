#include <gtest/gtest.h>

#include "algorithms/single_scan/gnn.h"
#include "algorithms/single_scan/nn.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"

namespace mda {
namespace {

using testing::cost_of;

/// Small problems with two dimensions, with and without tracks, many of them without the columns
/// that leave an exactly-once row alone.
AssociationProblem two_dimensional(std::uint64_t seed) {
  testing::RandomShape shape;
  shape.dimensions = 2;
  shape.rows_per_dimension = 4;
  shape.columns = 14;
  shape.tracks = seed % 2 == 0;
  shape.exactly_once = 0.25 * static_cast<double>(seed % 5);
  shape.lone_columns = seed % 3 == 0;
  shape.integer_costs = seed % 7 == 0;
  shape.presence = 0.8;
  return testing::random_problem(shape, seed);
}

TEST(Gnn, FillsExactlyOnceRowsOfBothDimensions) {
  const auto gnn = make_gnn();
  int infeasible = 0;
  int forced = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = two_dimensional(seed);
    const auto best = testing::optimum(problem);
    const Solution solution = gnn->solve(problem, Budget{});
    if (!best.has_value()) {
      ++infeasible;
      EXPECT_EQ(solution.status, Status::kNoAnswer);
      continue;
    }
    forced += problem.shape().always_feasible ? 0 : 1;
    ASSERT_EQ(solution.status, Status::kOptimal);
    EXPECT_EQ(testing::row_violation(problem, solution.x), 0.0);
    EXPECT_NEAR(cost_of(problem, solution.x), *best, testing::tolerance(problem));
    EXPECT_NEAR(testing::certified_bound(problem, solution.row_dual), *best,
                testing::tolerance(problem));
  }
  EXPECT_GE(infeasible, 100);
  EXPECT_GE(forced, 100);
}

TEST(Gnn, DeclinesMoreThanTwoDimensions) {
  Shape shape;
  shape.dimensions = 3;
  EXPECT_FALSE(make_gnn()->can_solve(shape).ok);
  EXPECT_FALSE(make_nn()->can_solve(shape).ok);
}

/// Both tracks want plot 2; track 1 gains more from it. There is no second choice for track 0.
TEST(Nn, TheLoserOfAPlotGetsNone) {
  ProblemBuilder builder;
  builder.add_row(0, RowUse::kAtMostOnce);
  builder.add_row(0, RowUse::kAtMostOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_column(-4.0, std::vector{0});
  builder.add_column(-6.0, std::vector{0, 2});
  builder.add_column(-5.0, std::vector{0, 3});
  builder.add_column(-3.0, std::vector{1, 2});
  builder.add_column(-2.0, std::vector{1, 3});
  const AssociationProblem problem = builder.build();
  const Solution nearest = make_nn()->solve(problem, Budget{});
  EXPECT_EQ(nearest.x, (std::vector<double>{1, 0, 0, 1, 0}));
  EXPECT_EQ(cost_of(problem, make_gnn()->solve(problem, Budget{}).x), -8.0);
}

TEST(Nn, AFreePlotIsUsedAloneIfThatPays) {
  ProblemBuilder builder;
  builder.add_row(0, RowUse::kAtMostOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_column(-1.0, std::vector{0, 1});
  builder.add_column(-7.0, std::vector{1});
  builder.add_column(-7.0, std::vector{2});
  builder.add_column(3.0, std::vector{0});
  const Solution solution = make_nn()->solve(builder.build(), Budget{});
  EXPECT_EQ(solution.x, (std::vector<double>{1, 0, 1, 0}));
}

}  // namespace
}  // namespace mda
