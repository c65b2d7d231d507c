#include "algorithms/adapters/scan_by_scan.h"

#include <gtest/gtest.h>

#include <string_view>

#include "algorithms/catalog.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_trees.h"

namespace mda {
namespace {

using testing::cost_of;
using testing::random_tree_problem;
using testing::random_tree_shape;
using testing::TreeShape;

std::unique_ptr<Associator> lifted(std::string_view inner) {
  return make_scan_by_scan(find_algorithm(inner)->make());
}

double solve(const AssociationProblem& problem, std::string_view inner) {
  const auto by_scan = lifted(inner);
  EXPECT_TRUE(by_scan->can_solve(problem.shape()).ok);
  const Solution solution = by_scan->solve(problem, Budget{});
  EXPECT_EQ(solution.status, Status::kFeasible);
  EXPECT_EQ(testing::row_violation(problem, solution.x), 0.0);
  return cost_of(problem, solution.x);
}

TEST(ScanByScan, WithOneScanNothingCanGoWrong) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = random_tree_shape(seed, seed % 2 == 0);
    shape.scans = 1;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    EXPECT_NEAR(solve(problem, "gnn"), *testing::optimum(problem), testing::tolerance(problem));
  }
}

TEST(ScanByScan, WithMoreScansIsOftenOptimalAndNeverBetter) {
  int optimal = 0;
  int worse = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem =
        random_tree_problem(random_tree_shape(seed, seed % 2 == 0), seed);
    const double best = *testing::optimum(problem);
    const double cost = solve(problem, "gnn");
    EXPECT_GE(cost, best - testing::tolerance(problem));
    ++(cost > best + testing::tolerance(problem) ? worse : optimal);
    EXPECT_GE(solve(problem, "nn"), best - testing::tolerance(problem));
  }
  EXPECT_GE(optimal, 150);
  EXPECT_GE(worse, 20);
}

TEST(ScanByScan, OrderDoesNotMatter) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const TreeShape shape = random_tree_shape(seed, seed % 2 == 0);
    const AssociationProblem problem = random_tree_problem(shape, seed);
    const AssociationProblem other = random_tree_problem(shape, seed, 7);
    EXPECT_NEAR(solve(problem, "gnn"), solve(other, "gnn"), testing::tolerance(problem));
    EXPECT_NEAR(solve(problem, "nn"), solve(other, "nn"), testing::tolerance(problem));
  }
}

TEST(ScanByScan, DeclinesProblemsWithoutATree) {
  const auto by_scan = lifted("gnn");
  EXPECT_FALSE(by_scan->can_solve(Shape{}).ok);
}

TEST(ScanByScan, IsAtTheEndOfItsTimeWhenTheInnerAlgorithmIs) {
  const AssociationProblem problem = random_tree_problem(TreeShape{}, 1);
  Budget budget;
  budget.deadline = Clock::now() - std::chrono::seconds(1);
  const Solution solution = lifted("gnn")->solve(problem, budget);
  EXPECT_EQ(solution.status, Status::kNoAnswer);
  EXPECT_EQ(solution.stop, Stop::kDeadline);
}

}  // namespace
}  // namespace mda
