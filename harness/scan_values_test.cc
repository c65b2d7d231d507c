#include "harness/scan_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/catalog.h"
#include "harness/referee.h"
#include "scenarios/cartesian/position_windows.h"
#include "scenarios/groups.h"
#include "scenarios/world/draws.h"

namespace mda {
namespace {

/// Windows of two or ten targets in dense clutter, advanced by the truth.
template <typename See>
void for_windows(const char* scenario, See see) {
  PositionWindows windows(*find_scenario(scenario), 1, 1);
  while (windows.next()) {
    see(windows.window().problem, static_cast<std::uint64_t>(windows.newest_scan()));
    windows.advance(windows.true_beliefs());
  }
}

/// A distribution for every track.
std::vector<double> random_marginals(const AssociationProblem& problem, std::uint64_t seed) {
  auto engine = draws({.seed = seed, .scenario = "marginals"});
  std::vector<double> x;
  std::vector<double> sums(static_cast<std::size_t>(problem.rows()), 0.0);
  for (int j = 0; j < problem.columns(); ++j) {
    x.push_back(draw_uniform(engine, 0.0, 1.0));
    sums[static_cast<std::size_t>(problem.rows_of(j)[0])] += x.back();
  }
  for (int j = 0; j < problem.columns(); ++j) {
    x[static_cast<std::size_t>(j)] /= sums[static_cast<std::size_t>(problem.rows_of(j)[0])];
  }
  return x;
}

/// The least -sum ln x over choices, one track after the other.
double least_cost(const AssociationProblem& problem, const std::vector<double>& x, int track,
                  std::vector<int>& used) {
  const int tracks = problem.views()->pairs->tracks();
  if (track == tracks) return 0.0;
  double best = std::numeric_limits<double>::infinity();
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    if (rows[0] != track) continue;
    const int plot = rows.size() > 1 ? rows[1] : kNoRow;
    if (plot != kNoRow && std::ranges::count(used, plot) > 0) continue;
    used.push_back(plot);
    best = std::min(
        best, least_cost(problem, x, track + 1, used) - std::log(x[static_cast<std::size_t>(j)]));
    used.pop_back();
  }
  return best;
}

TEST(ScanValues, HardDecisionsAreTheMostProbableChoice) {
  for_windows("lee-parallel-c0.8", [&](const AssociationProblem& problem, std::uint64_t seed) {
    const std::vector<double> x = random_marginals(problem, seed);
    const std::vector<double> choice = decided(problem, x).x;
    EXPECT_TRUE(examine(problem, choice).is_choice());
    double cost = 0.0;
    for (std::size_t j = 0; j < x.size(); ++j) cost -= choice[j] * std::log(x[j]);
    std::vector<int> used;
    EXPECT_NEAR(cost, least_cost(problem, x, 0, used), 1e-9);
  });
}

TEST(ScanValues, ColumnsWithoutAChanceAreOnlyTakenWhereTheyMust) {
  int contested = 0;
  for_windows("lee-parallel-c0.8", [&](const AssociationProblem& problem, std::uint64_t) {
    const PairView& pairs = *problem.views()->pairs;
    for (int plot = 0; plot < pairs.plots(); ++plot) {
      const int first = pairs.column[pairs.at(0, plot)];
      const int second = pairs.column[pairs.at(1, plot)];
      if (first == kNoColumn || second == kNoColumn) continue;
      ++contested;
      std::vector<double> x(static_cast<std::size_t>(problem.columns()), 0.0);
      x[static_cast<std::size_t>(first)] = 1.0;
      x[static_cast<std::size_t>(second)] = 1.0;
      EXPECT_TRUE(are_in_conflict(problem, largest_by_track(problem, x)));
      EXPECT_TRUE(examine(problem, decided(problem, x).x).is_choice());
    }
  });
  EXPECT_GT(contested, 0);
}

TEST(ScanValues, TheLargestOfATrackIsItsOwn) {
  for_windows("lee-ten-uniform", [](const AssociationProblem& problem, std::uint64_t seed) {
    const std::vector<double> x = random_marginals(problem, seed);
    const std::vector<int> largest = largest_by_track(problem, x);
    ASSERT_EQ(largest.size(), 10U);
    for (int j = 0; j < problem.columns(); ++j) {
      const int best = largest[static_cast<std::size_t>(problem.rows_of(j)[0])];
      EXPECT_GE(x[static_cast<std::size_t>(best)], x[static_cast<std::size_t>(j)]);
      EXPECT_EQ(problem.rows_of(best)[0], problem.rows_of(j)[0]);
    }
  });
}

TEST(ScanValues, ChoicesAreFollowedUnderEitherUpdate) {
  const auto solver = reference_algorithm().make();
  for_windows("lee-ten", [&](const AssociationProblem& problem, std::uint64_t) {
    Solution solution = solver->solve(problem, Budget{});
    ASSERT_EQ(solution.answer, Answer::kSelection);
    EXPECT_FALSE(are_in_conflict(problem, largest_by_track(problem, solution.x)));
    for (const Answer answer : {Answer::kSelection, Answer::kMarginals, Answer::kRelaxation}) {
      solution.answer = answer;
      for (const TrackUpdate update : {TrackUpdate::kSoft, TrackUpdate::kHard}) {
        EXPECT_EQ(values_to_follow(problem, solution, update), solution.x);
      }
    }
  });
}

TEST(ScanValues, MarginalsAreFollowedSoftlyOrHard) {
  for_windows("lee-parallel-c0.8", [&](const AssociationProblem& problem, std::uint64_t seed) {
    Solution solution;
    solution.answer = Answer::kMarginals;
    solution.x = random_marginals(problem, seed);
    EXPECT_EQ(values_to_follow(problem, solution, TrackUpdate::kSoft), solution.x);
    EXPECT_EQ(values_to_follow(problem, solution, TrackUpdate::kHard),
              decided(problem, solution.x).x);
  });
}

/// Marginals of 0 and 1 that claim a plot twice decide by themselves; so does a relaxation.
TEST(ScanValues, WholeAnswersKeepTheirConflicts) {
  int conflicts = 0;
  for_windows("lee-parallel-c0.8", [&](const AssociationProblem& problem, std::uint64_t seed) {
    Solution solution;
    solution.answer = Answer::kRelaxation;
    solution.x = random_marginals(problem, seed);
    const std::vector<int> largest = largest_by_track(problem, solution.x);
    std::vector<double> whole(solution.x.size(), 0.0);
    for (const int column : largest) whole[static_cast<std::size_t>(column)] = 1.0;
    EXPECT_EQ(values_to_follow(problem, solution, TrackUpdate::kSoft), whole);
    solution.answer = Answer::kMarginals;
    solution.x = whole;
    EXPECT_EQ(values_to_follow(problem, solution, TrackUpdate::kHard), whole);
    conflicts += are_in_conflict(problem, largest) ? 1 : 0;
  });
  EXPECT_GT(conflicts, 0) << "the test shows nothing";
}

}  // namespace
}  // namespace mda
