#include "algorithms/relaxation/normal_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "algorithms/relaxation/staged_assignment.h"
#include "algorithms/testing/draw.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"

namespace mda {
namespace {

using testing::RandomShape;

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

RandomShape shape_of(std::uint64_t seed) {
  RandomShape shape = testing::random_shape(seed, 30);
  shape.lone_columns = true;
  shape.integer_costs = false;
  return shape;
}

AssociationProblem problem_of(std::uint64_t seed) {
  return testing::random_problem(shape_of(seed), seed);
}

/// The component as a problem of its own.
AssociationProblem problem_of(const NormalComponent& component) {
  ProblemBuilder builder;
  for (const int level : component.row_level) builder.add_row(level, RowUse::kAtMostOnce);
  for (int j = 0; j < component.columns(); ++j) {
    builder.add_column(component.cost[index(j)], component.rows_of(j));
  }
  return builder.build();
}

/// The same steps for whoever iterates on them.
void expect_alike(const NormalForm& a, const NormalForm& b) {
  ASSERT_EQ(a.components.size(), b.components.size());
  for (std::size_t i = 0; i < a.components.size(); ++i) {
    EXPECT_EQ(a.components[i].row_level, b.components[i].row_level);
    EXPECT_EQ(a.components[i].column_begin, b.components[i].column_begin);
    EXPECT_EQ(a.components[i].row_index, b.components[i].row_index);
    EXPECT_EQ(a.components[i].cost, b.components[i].cost);
  }
}

TEST(NormalForm, DependsOnNeitherOrderNorUnit) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = problem_of(seed);
    const NormalForm form = normal_form(problem);
    expect_alike(form, normal_form(testing::reorder(problem, seed)));
    const NormalForm scaled = normal_form(testing::with_costs(problem, 64.0));
    expect_alike(form, scaled);
    if (!form.components.empty()) {
      EXPECT_EQ(scaled.unit, 64.0 * form.unit);
    }
  }
}

TEST(NormalForm, DoesNotSeeConstantsOnExactlyOnceRows) {
  int shifted = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = problem_of(seed);
    for (int r = 0; r < problem.rows(); ++r) {
      if (problem.use(r) != RowUse::kExactlyOnce) continue;
      expect_alike(normal_form(problem), normal_form(testing::with_costs(problem, 1.0, 3.25, r)));
      ++shifted;
      break;
    }
  }
  EXPECT_GE(shifted, 50);
}

TEST(NormalForm, HasTheOptimumOfTheProblem) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = problem_of(seed);
    const NormalForm form = normal_form(problem);
    double cost = 0.0;
    for (const double charge : form.charge) cost += charge;
    for (const NormalComponent& component : form.components) {
      EXPECT_TRUE(std::all_of(component.cost.begin(), component.cost.end(),
                              [](double c) { return -1.0 < c && c < 0.0; }));
      cost += form.unit * *testing::optimum(problem_of(component));
    }
    EXPECT_NEAR(cost, *testing::optimum(problem), testing::tolerance(problem));
  }
}

TEST(NormalForm, NeedsAColumnForEveryExactlyOnceRow) {
  ProblemBuilder builder;
  builder.add_row(1, RowUse::kExactlyOnce);
  EXPECT_THROW((void)normal_form(builder.build()), std::invalid_argument);
}

/// For whatever multipliers: the value is a bound, its multipliers prove it, and the choice made
/// from it breaks no row.
TEST(StagedAssignment, BoundsAndRecovers) {
  int components = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    for (const NormalComponent& component : normal_form(problem_of(seed)).components) {
      const AssociationProblem problem = problem_of(component);
      testing::Draw draw(seed);
      std::vector<double> u(index(component.rows()), 0.0);
      for (double& value : u) value = draw.chance(0.5) ? 0.3 * draw.unit() : 0.0;
      StagedAssignment stages(component);
      const RelaxedOptimum& relaxed = stages.relax(u);
      const double best = *testing::optimum(problem);
      EXPECT_LE(relaxed.bound, best + 1e-9);
      EXPECT_NEAR(relaxed.bound, testing::certified_bound(problem, relaxed.multiplier), 1e-9);
      std::vector<double> x(index(component.columns()), 0.0);
      for (const int j : stages.recover(u)) x[index(j)] += 1.0;
      EXPECT_EQ(testing::row_violation(problem, x), 0.0);
      EXPECT_GE(testing::cost_of(problem, x), best - 1e-9);
      ++components;
    }
  }
  EXPECT_GE(components, 300);
}

}  // namespace
}  // namespace mda
