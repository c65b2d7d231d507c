#include "algorithms/adapters/decided.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/random_scans.h"

namespace mda {
namespace {

std::unique_ptr<Associator> decider(std::string_view marginals) {
  return make_decided(find_algorithm(marginals)->make(), find_algorithm("gnn")->make());
}

/// -ln of the probability of what every track does, nothing included.
double surprise(const AssociationProblem& problem, const std::vector<double>& probability,
                const std::vector<double>& choice) {
  std::vector<double> nothing(static_cast<std::size_t>(problem.rows()), 1.0);
  std::vector<char> busy(static_cast<std::size_t>(problem.rows()), 0);
  double sum = 0.0;
  for (int j = 0; j < problem.columns(); ++j) {
    const auto column = static_cast<std::size_t>(j);
    const auto track = static_cast<std::size_t>(problem.rows_of(j).front());
    nothing[track] -= probability[column];
    if (choice[column] == 0.0) continue;
    busy[track] = 1;
    sum -= std::log(probability[column]);
  }
  for (int r = 0; r < problem.rows(); ++r) {
    const auto row = static_cast<std::size_t>(r);
    if (problem.dimension(r) == 0 && busy[row] == 0) sum -= std::log(nothing[row]);
  }
  return sum;
}

/// The least surprise of any choice.
double least_surprise(const AssociationProblem& problem, const std::vector<double>& probability) {
  double least = INFINITY;
  const auto choices = std::size_t{1} << problem.columns();
  for (std::size_t mask = 0; mask < choices; ++mask) {
    std::vector<double> choice;
    for (int j = 0; j < problem.columns(); ++j) {
      choice.push_back(((mask >> j) & 1U) != 0 ? 1.0 : 0.0);
    }
    if (testing::row_violation(problem, choice) > 0.0) continue;
    least = std::min(least, surprise(problem, probability, choice));
  }
  return least;
}

TEST(Decided, ChoosesTheLargestProductOfProbabilities) {
  int not_the_cheapest = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem =
        testing::random_scan({.tracks = 3, .plots = 3, .spread_nats = 4.0}, seed);
    for (const auto* name : {"jpda", "pda", "lbp"}) {
      const std::vector<double> probability =
          find_algorithm(name)->make()->solve(problem, Budget{}).x;
      const Solution decision = decider(name)->solve(problem, Budget{});
      EXPECT_EQ(decision.answer, Answer::kSelection);
      EXPECT_EQ(decision.x, decided(problem, probability).x);
      EXPECT_EQ(testing::row_violation(problem, decision.x), 0.0);
      EXPECT_NEAR(surprise(problem, probability, decision.x), least_surprise(problem, probability),
                  1e-9);
      const double best = *testing::optimum(problem);
      not_the_cheapest += testing::cost_of(problem, decision.x) > best + 1e-9 ? 1 : 0;
    }
  }
  EXPECT_GE(not_the_cheapest, 10);
}

TEST(Decided, KeepsTheRowsOfAllKindsOfProblems) {
  const auto algorithm = decider("jpda");
  int taken = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomShape shape;
    shape.dimensions = 2;
    shape.rows_per_dimension = 4;
    shape.columns = 10;
    shape.tracks = seed % 2 == 0;
    shape.exactly_once = 0.25 * static_cast<double>(seed % 5);
    const AssociationProblem problem = testing::random_problem(shape, seed);
    if (!algorithm->can_solve(problem.shape()).ok) continue;
    ++taken;
    const Solution decision = algorithm->solve(problem, Budget{});
    ASSERT_EQ(decision.status, Status::kFeasible);
    EXPECT_EQ(testing::row_violation(problem, decision.x), 0.0);
  }
  EXPECT_GE(taken, 400);
}

/// A plot that no track takes starts a track of its own if that is more probable than clutter.
TEST(Decided, AFreePlotIsWhatIsMoreProbable) {
  for (const double cost : {-1.0, 1.0}) {
    ProblemBuilder builder;
    builder.add_row(0, RowUse::kAtMostOnce);
    builder.add_row(1, RowUse::kAtMostOnce);
    builder.add_column(5.0, std::vector{0, 1});
    builder.add_column(cost, std::vector{1});
    const std::vector<double> x = decider("jpda")->solve(builder.build(), Budget{}).x;
    EXPECT_EQ(x, (std::vector<double>{0.0, cost < 0.0 ? 1.0 : 0.0}));
  }
}

TEST(Decided, HandsOnWhyThereIsNoAnswer) {
  const AssociationProblem problem = testing::random_scan({.tracks = 30, .plots = 30}, 1);
  const Solution solution = decider("jpda")->solve(problem, Budget{});
  EXPECT_EQ(solution.status, Status::kNoAnswer);
  EXPECT_EQ(solution.answer, Answer::kSelection);
  EXPECT_FALSE(solution.note.empty());
}

}  // namespace
}  // namespace mda
