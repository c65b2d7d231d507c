#include "algorithms/tree/mht.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "algorithms/testing/contract.h"
#include "algorithms/testing/draw.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/random_trees.h"

namespace mda::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kAll = 1'000'000;
constexpr int kMostRows = 11;  ///< of a window whose hypotheses can all be kept

double cost_with(const MhtOptions& options, const AssociationProblem& problem) {
  const Solution solution = make_mht(options)->solve(problem, Budget{});
  EXPECT_EQ(solution.status, Status::kFeasible);
  EXPECT_EQ(row_violation(problem, solution.x), 0.0);
  return cost_of(problem, solution.x);
}

/// Known tracks that must go on, or births and false alarms.
class MhtTest : public ::testing::TestWithParam<bool> {
 protected:
  /// Every third with gates so narrow that there are several clusters.
  static TreeShape shape(std::uint64_t seed) {
    TreeShape shape = random_tree_shape(seed, GetParam());
    if (seed % 3 == 0) shape.gate_nats = -5.0;
    return shape;
  }
};
INSTANTIATE_TEST_SUITE_P(Births, MhtTest, ::testing::Bool());

TEST_P(MhtTest, WithAllHypothesesTheAnswerIsOptimal) {
  int one_is_not_enough = 0;
  int several_clusters = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_tree_problem(shape(seed), seed);
    if (problem.rows() > kMostRows) continue;
    const double best = *optimum(problem);
    EXPECT_NEAR(cost_with({kAll, kInfinity}, problem), best, tolerance(problem));
    EXPECT_NEAR(cost_with({kAll, kInfinity, true}, problem), best, tolerance(problem));
    const double with_one = cost_with({1, kInfinity}, problem);
    EXPECT_GE(with_one, best - tolerance(problem));
    one_is_not_enough += with_one > best + tolerance(problem) ? 1 : 0;
    several_clusters += problem.shape().components > 1 ? 1 : 0;
  }
  EXPECT_GE(one_is_not_enough, 10);
  EXPECT_GE(several_clusters, 30);
}

TEST_P(MhtTest, OneScanNeedsOneHypothesis) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape one_scan = shape(seed);
    one_scan.scans = 1;
    one_scan.plots = 1 + static_cast<int>(seed % 8);
    const AssociationProblem problem = random_tree_problem(one_scan, seed);
    EXPECT_NEAR(cost_with({1, 0.0}, problem), *optimum(problem), tolerance(problem));
    EXPECT_NEAR(cost_with({1, 0.0, true}, problem), *optimum(problem), tolerance(problem));
  }
}

TEST_P(MhtTest, OrderDoesNotMatter) {
  for (const MhtOptions& options : {MhtOptions{}, MhtOptions{3, kInfinity}, MhtOptions{100, 2.0},
                                    MhtOptions{100, 30.0, true}, MhtOptions{3, 30.0, true}}) {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
      SCOPED_TRACE(seed);
      const AssociationProblem plain = random_tree_problem(shape(seed), seed);
      const AssociationProblem other = random_tree_problem(shape(seed), seed, seed);
      EXPECT_NEAR(cost_with(options, plain), cost_with(options, other), tolerance(plain));
    }
  }
}

/// The same window with plots that must be used: each gets a false alarm, a column without a node,
/// that costs something or gains something.
AssociationProblem with_false_alarms(const AssociationProblem& window, std::uint64_t seed) {
  Draw draw(seed);
  ProblemBuilder builder;
  for (int r = 0; r < window.rows(); ++r) {
    const bool plot = window.dimension(r) > 0;
    builder.add_row(window.dimension(r), plot ? RowUse::kExactlyOnce : window.use(r));
  }
  for (int j = 0; j < window.columns(); ++j) {
    builder.add_column(window.cost(j), window.rows_of(j));
  }
  for (int r = 0; r < window.rows(); ++r) {
    if (window.dimension(r) > 0) builder.add_column(6.0 * draw.unit() - 3.0, std::vector{r});
  }
  AssociationProblem problem = builder.build();
  problem.attach(std::make_shared<const Views>(*window.views()));
  return problem;
}

TEST_P(MhtTest, FalseAlarmsMayHaveColumns) {
  int differently = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem window = random_tree_problem(shape(seed), seed);
    if (window.rows() > kMostRows) continue;
    const AssociationProblem problem = with_false_alarms(window, seed);
    ASSERT_TRUE(problem.shape().always_feasible);
    const double best = *optimum(problem);
    EXPECT_NEAR(cost_with({kAll, kInfinity}, problem), best, tolerance(problem));
    Budget over;
    over.deadline = Clock::now();
    const Solution early = make_mht({})->solve(problem, over);
    EXPECT_EQ(row_violation(problem, early.x), 0.0);
    differently += cost_of(problem, early.x) > best + tolerance(problem) ? 1 : 0;
  }
  EXPECT_GE(differently, 50) << "the false alarms are the best answer too often";
}

TEST_P(MhtTest, NothingIsRemembered) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    expect_no_memory([] { return make_mht({}); }, random_tree_problem(shape(seed), seed),
                     random_tree_problem(shape(seed + 50), seed + 50));
  }
}

TEST_P(MhtTest, AtTheDeadlineTracksAreLeftToThemselves) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const int microseconds : {-1, 5, 20, 100}) {
      const AssociationProblem problem = random_tree_problem(shape(seed), seed);
      expect_honest_deadline([] { return make_mht({}); }, problem, optimum(problem), microseconds);
    }
  }
}

TEST(MhtTest, LookingAheadFindsMoreOptima) {
  int optimal = 0;
  int optimal_ahead = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const AssociationProblem problem = random_tree_problem(random_tree_shape(seed, true), seed);
    const double best = *optimum(problem) + tolerance(problem);
    optimal += cost_with({3, kInfinity}, problem) <= best ? 1 : 0;
    optimal_ahead += cost_with({3, kInfinity, true}, problem) <= best ? 1 : 0;
  }
  EXPECT_GT(optimal_ahead, optimal);
}

TEST(MhtTest, DeclinesWindowsWithoutATree) {
  const AssociationProblem problem = random_problem(RandomShape{}, 1);
  const Verdict verdict = make_mht({})->can_solve(problem.shape());
  EXPECT_FALSE(verdict.ok);
  EXPECT_NE(verdict.reason.find("tree"), std::string::npos);
}

TEST(MhtTest, RefusesWhatMakesNoSense) {
  EXPECT_THROW((void)make_mht({0, 1.0}), std::invalid_argument);
  EXPECT_THROW((void)make_mht({1, -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace mda::testing
