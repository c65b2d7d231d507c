#include "algorithms/relaxation/first_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

AssociationProblem problem_of(std::uint64_t seed) {
  testing::RandomShape shape = testing::random_shape(seed, 60);
  shape.lone_columns = true;
  return testing::random_problem(shape, seed);
}

/// The component's columns at other costs.
AssociationProblem with_costs(const NormalComponent& component, const std::vector<double>& costs) {
  ProblemBuilder builder;
  for (const int level : component.row_level) builder.add_row(level, RowUse::kAtMostOnce);
  for (int j = 0; j < component.columns(); ++j) {
    builder.add_column(costs[index(j)], component.rows_of(j));
  }
  return builder.build();
}

double lp_value(const AssociationProblem& problem) {
  return find_algorithm("lp")->make()->solve(problem, Budget{}).lower_bound;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// |A'v|^2 / |v|^2, a lower bound on |A|^2, after many rounds of v <- A A'v.
double rayleigh(const NormalComponent& component) {
  std::vector<double> v(index(component.rows()), 1.0);
  double value = 0.0;
  for (int round = 0; round < 2000; ++round) {
    std::vector<double> next(v.size(), 0.0);
    double length2 = 0.0;
    for (int j = 0; j < component.columns(); ++j) {
      double sum = 0.0;
      for (const int r : component.rows_of(j)) sum += v[index(r)];
      for (const int r : component.rows_of(j)) next[index(r)] += sum;
      length2 += sum * sum;
    }
    value = length2 / dot(v, v);
    for (std::size_t r = 0; r < v.size(); ++r) v[r] = next[r] / value;
  }
  return value;
}

TEST(PrimalDual, TheNormIsNotTooSmallAndHardlyTooLarge) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    for (const NormalComponent& component : normal_form(problem_of(seed)).components) {
      const double least = rayleigh(component);
      EXPECT_GE(squared_norm(component), least * (1.0 - 1e-9));
      EXPECT_LE(squared_norm(component), least * 1.02);
    }
  }
}

/// All pairs of m and n rows: the incidence matrix of a complete bipartite graph.
TEST(PrimalDual, TheNormOfAllPairsIsTheNumberOfRows) {
  ProblemBuilder builder;
  for (int r = 0; r < 7; ++r) builder.add_row(r < 3 ? 0 : 1, RowUse::kAtMostOnce);
  for (int i = 0; i < 3; ++i) {
    for (int j = 3; j < 7; ++j) builder.add_column(-1.0, std::vector{i, j});
  }
  EXPECT_NEAR(squared_norm(normal_form(builder.build()).components.front()), 7.0, 0.07);
}

/// x is optimal for a convex cost just when no point of the relaxation lies downhill.
TEST(PrimalDual, WithAlphaItsLimitIsTheOptimumOfTheQuadraticCost) {
  int tested = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    for (const NormalComponent& component : normal_form(problem_of(seed)).components) {
      for (const double alpha : {0.1, 1.0}) {
        SCOPED_TRACE(::testing::Message() << seed << " " << alpha);
        const PrimalDualOptions options{.alpha = alpha, .tolerance = 1e-7, .iterations = 200000};
        const PrimalDualResult result = primal_dual(component, options, Budget{});
        ASSERT_EQ(result.stop, Stop::kFinished);
        std::vector<double> slope = component.cost;
        for (std::size_t j = 0; j < slope.size(); ++j) slope[j] += alpha * result.x[j];
        const AssociationProblem downhill = with_costs(component, slope);
        EXPECT_LE(testing::row_violation(downhill, result.x), 1e-6);
        EXPECT_NEAR(lp_value(downhill), dot(slope, result.x), 1e-5);
        ++tested;
      }
    }
  }
  EXPECT_GE(tested, 200);
}

TEST(PrimalDual, TheShareOfTheStepMovesNoLimit) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    for (const NormalComponent& component : normal_form(problem_of(seed)).components) {
      PrimalDualOptions options{.alpha = 0.5, .tolerance = 1e-8, .iterations = 200000};
      const PrimalDualResult half = primal_dual(component, options, Budget{});
      options.step = 0.9;
      const PrimalDualResult larger = primal_dual(component, options, Budget{});
      for (std::size_t j = 0; j < half.x.size(); ++j) EXPECT_NEAR(half.x[j], larger.x[j], 1e-5);
    }
  }
}

/// Above the bound on its step the multipliers swing for ever.
TEST(PrimalDual, DoesNotSettleAboveTheStepBound) {
  ProblemBuilder builder;
  builder.add_row(0, RowUse::kAtMostOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_column(-1.0, std::vector{0, 1});
  const NormalForm form = normal_form(builder.build());
  PrimalDualOptions options{.alpha = 0.1, .step = 0.95};
  EXPECT_EQ(primal_dual(form.components.front(), options, Budget{}).stop, Stop::kFinished);
  options.step = 1.1;
  EXPECT_EQ(primal_dual(form.components.front(), options, Budget{}).stop, Stop::kIterationLimit);
}

TEST(PrimalDual, MoreIterationsNeverLoosenTheBound) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    for (const NormalComponent& component : normal_form(problem_of(seed)).components) {
      for (const double alpha : {0.0, 0.05}) {
        SCOPED_TRACE(::testing::Message() << seed << " " << alpha);
        double before = -std::numeric_limits<double>::infinity();
        for (const int iterations : {0, 32, 64, 96, 128, 160}) {
          const double bound =
              primal_dual(component, {.alpha = alpha, .iterations = iterations}, Budget{}).bound;
          EXPECT_GE(bound, before);
          before = bound;
        }
      }
    }
  }
}

TEST(Pdhg, ItsBoundIsThatOfTheRelaxation) {
  int settled = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = problem_of(seed);
    const Solution pdhg = make_pdhg()->solve(problem, Budget{});
    const double lp = lp_value(problem);
    EXPECT_LE(pdhg.lower_bound, lp + testing::tolerance(problem));
    EXPECT_NEAR(pdhg.lower_bound, testing::certified_bound(problem, pdhg.row_dual),
                testing::tolerance(problem));
    if (pdhg.stop != Stop::kFinished) continue;
    ++settled;
    double size = 1.0;
    for (const double cost : problem.costs()) size += std::abs(cost);
    EXPECT_GE(pdhg.lower_bound, lp - 1e-5 * size);
  }
  EXPECT_GE(settled, 490);
}

/// At the limit x the bound is c x - alpha sum x (1 - x), and c x is no less than the relaxation's
/// optimum: alpha per row is the most that the quadratic term can cost.
TEST(MapadaWindow, ItsBoundIsAsGoodAsAlphaIsSmall) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = problem_of(seed);
    const NormalForm form = normal_form(problem);
    const Solution answer =
        make_first_order({.alpha = 0.02, .tolerance = 1e-6, .iterations = 200000})
            ->solve(problem, Budget{});
    const double lp = lp_value(problem);
    EXPECT_LE(answer.lower_bound, lp + testing::tolerance(problem));
    if (answer.stop != Stop::kFinished) continue;
    EXPECT_GE(answer.lower_bound, lp - 0.02 * form.unit * problem.rows());
  }
}

}  // namespace
}  // namespace mda
