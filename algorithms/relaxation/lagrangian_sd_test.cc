#include "algorithms/relaxation/lagrangian_sd.h"

#include <gtest/gtest.h>

#include <iterator>

#include "algorithms/catalog.h"
#include "algorithms/relaxation/normal_form.h"
#include "algorithms/testing/draw.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/random_trees.h"

namespace mda {
namespace {

using testing::cost_of;
using testing::RandomShape;

/// Plots of three sensors at one instant.
AssociationProblem three_sensors(std::uint64_t seed) {
  RandomShape shape;
  shape.dimensions = 3;
  shape.rows_per_dimension = 4;
  shape.columns = 40;
  shape.tracks = false;
  shape.presence = 0.9;
  shape.exactly_once = seed % 3 == 0 ? 0.5 : 0.0;
  return testing::random_problem(shape, seed);
}

/// The same problem with its dimensions in another order, so that others are relaxed.
AssociationProblem permute_dimensions(const AssociationProblem& problem, std::uint64_t seed) {
  constexpr int kMostDimensions = 8;
  const std::vector<int> order = testing::Draw(seed).permutation(kMostDimensions);
  ProblemBuilder builder;
  for (int r = 0; r < problem.rows(); ++r) {
    builder.add_row(order[static_cast<std::size_t>(problem.dimension(r))], problem.use(r));
  }
  for (int j = 0; j < problem.columns(); ++j) {
    builder.add_column(problem.cost(j), problem.rows_of(j));
  }
  return builder.build();
}

/// Whether the optimum was proven; what is claimed must be true in any case.
bool solve_and_check(const AssociationProblem& problem) {
  const Solution solution = make_lagrangian_sd()->solve(problem, Budget{});
  const double best = *testing::optimum(problem);
  const double margin = testing::tolerance(problem);
  EXPECT_EQ(testing::row_violation(problem, solution.x), 0.0);
  EXPECT_GE(cost_of(problem, solution.x), best - margin);
  EXPECT_LE(solution.lower_bound, best + margin);
  EXPECT_NEAR(testing::certified_bound(problem, solution.row_dual), solution.lower_bound, margin);
  if (solution.status != Status::kOptimal) return false;
  EXPECT_NEAR(cost_of(problem, solution.x), best, margin);
  return true;
}

/// Dense axial: every index of three exactly once, costs of either sign.
AssociationProblem axial_problem(int size, std::uint64_t seed) {
  testing::Draw draw(seed);
  ProblemBuilder builder;
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (int i = 0; i < size; ++i) builder.add_row(dimension, RowUse::kExactlyOnce);
  }
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      for (int k = 0; k < size; ++k) {
        builder.add_column(10.0 * draw.unit() - static_cast<double>(seed % 12),
                           std::vector{i, size + j, 2 * size + k});
      }
    }
  }
  return builder.build();
}

TEST(LagrangianSd, BracketsTheOptimumOfDenseAxialProblems) {
  int proven = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = axial_problem(1 + static_cast<int>(seed % 5), seed);
    ASSERT_TRUE(problem.shape().is_axial);
    ASSERT_TRUE(make_lagrangian_sd()->can_solve(problem.shape()).ok);
    proven += solve_and_check(problem) ? 1 : 0;
  }
  EXPECT_GE(proven, 20);
}

TEST(LagrangianSd, BracketsTheOptimumOfThreeSensors) {
  int proven = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    proven += solve_and_check(three_sensors(seed)) ? 1 : 0;
  }
  EXPECT_GE(proven, 200);
}

TEST(LagrangianSd, BracketsTheOptimumWhicheverDimensionsAreRelaxed) {
  int proven = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    RandomShape shape = testing::random_shape(seed, 40);
    shape.lone_columns = true;
    const AssociationProblem problem = testing::random_problem(shape, seed);
    proven += solve_and_check(permute_dimensions(problem, 1)) ? 1 : 0;
    proven += solve_and_check(permute_dimensions(problem, seed)) ? 1 : 0;
  }
  EXPECT_GE(proven, 400);
}

TEST(LagrangianSd, ProvesTheOptimumOfMostWindows) {
  int proven = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    proven += solve_and_check(testing::random_tree_problem(
                  testing::random_tree_shape(seed, seed % 2 == 0), seed))
                  ? 1
                  : 0;
  }
  EXPECT_GE(proven, 270);
}

TEST(LagrangianSd, NeedsOneIterationForTwoDimensions) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    RandomShape shape;
    shape.dimensions = 2;
    shape.rows_per_dimension = 6;
    shape.columns = 24;
    shape.exactly_once = seed % 2 == 0 ? 0.5 : 0.0;
    const AssociationProblem problem = testing::random_problem(shape, seed);
    const Solution solution = make_lagrangian_sd()->solve(problem, Budget{});
    EXPECT_EQ(solution.status, Status::kOptimal);
    EXPECT_NEAR(cost_of(problem, solution.x), *testing::optimum(problem),
                testing::tolerance(problem));
    EXPECT_EQ(solution.stats.iterations, std::ssize(normal_form(problem).components));
  }
}

/// The relaxed problem has whole optima, so its dual is worth as much as the LP (Geoffrion 1974)
/// and never more.
TEST(LagrangianSd, ApproachesTheBoundOfTheLpFromBelow) {
  const auto lp = find_algorithm("lp")->make();
  const auto lagrangian = make_lagrangian_sd();
  int close = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = three_sensors(seed);
    const double best = lp->solve(problem, Budget{}).lower_bound;
    const double bound = lagrangian->solve(problem, Budget{}).lower_bound;
    EXPECT_LE(bound, best + testing::tolerance(problem));
    if (bound >= best - 0.1) ++close;
  }
  EXPECT_GE(close, 160);
}

TEST(LagrangianSd, MoreIterationsDoNotHurt) {
  const auto one = make_lagrangian_sd(SubgradientOptions{.iterations = 1});
  const auto many = make_lagrangian_sd();
  int better = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = three_sensors(seed);
    const Solution first = one->solve(problem, Budget{});
    const Solution last = many->solve(problem, Budget{});
    EXPECT_LE(first.lower_bound, last.lower_bound + testing::tolerance(problem));
    EXPECT_GE(cost_of(problem, first.x), cost_of(problem, last.x) - testing::tolerance(problem));
    if (last.lower_bound > first.lower_bound + 0.01) ++better;
  }
  EXPECT_GE(better, 100);
}

}  // namespace
}  // namespace mda
