#include "algorithms/marginal/jpda.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "algorithms/marginal/jpda_enumerate.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/random_scans.h"
#include "algorithms/testing/tiny_problems.h"

namespace mda {
namespace {

using testing::gibbs_distribution;
using testing::random_scan;
using testing::ScanShape;

void expect_close(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t j = 0; j < a.size(); ++j) EXPECT_NEAR(a[j], b[j], tolerance) << "column " << j;
}

/// Every way in which jpda may go about a cluster.
std::vector<JpdaOptions> all_ways() {
  std::vector<JpdaOptions> ways;
  for (const Masked masked : {Masked::kCheaper, Masked::kTracks, Masked::kPlots}) {
    for (const bool portable : {false, true}) {
      ways.push_back({.masked = masked, .portable_kernel = portable});
    }
  }
  return ways;
}

/// One to four rows a side, columns twice, columns alone, rows that must.
AssociationProblem small_problem(std::uint64_t seed) {
  testing::RandomShape shape;
  shape.dimensions = 2;
  shape.rows_per_dimension = 1 + static_cast<int>(seed % 4);
  shape.columns = 14 - 2 * shape.rows_per_dimension;
  shape.tracks = seed % 3 != 0;
  shape.exactly_once = 0.3 * static_cast<double>(seed % 2);
  shape.neighbourhood = shape.rows_per_dimension;
  shape.presence = 0.85;
  return testing::random_problem(shape, seed);
}

TEST(Jpda, IsTheDistributionOverAllChoices) {
  int taken = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = small_problem(seed);
    if (!make_jpda({})->can_solve(problem.shape()).ok) continue;
    ++taken;
    const std::vector<double> expected = gibbs_distribution(problem).probability;
    for (const JpdaOptions& way : all_ways()) {
      expect_close(make_jpda(way)->solve(problem, Budget{}).x, expected, 1e-12);
    }
    expect_close(make_jpda_enumerate()->solve(problem, Budget{}).x, expected, 1e-12);
  }
  EXPECT_GE(taken, 400);
}

/// Clusters of up to 30 pairs: dense, long and thin, spread over a plane.
TEST(Jpda, AgreesWithEnumeration) {
  const std::array shapes = {
      ScanShape{.tracks = 5, .plots = 6},
      ScanShape{.tracks = 7, .plots = 3},
      ScanShape{.tracks = 15, .plots = 20, .length = 15.0, .gate = 1.1},
      ScanShape{.tracks = 10, .plots = 16, .length = 4.0, .height = 4.0, .gate = 0.9},
      ScanShape{.tracks = 1, .plots = 9},
      ScanShape{.tracks = 9, .plots = 1}};
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const ScanShape& shape : shapes) {
      SCOPED_TRACE(seed);
      const AssociationProblem problem = random_scan(shape, seed);
      const auto enumerate = make_jpda_enumerate();
      if (!enumerate->can_solve(problem.shape()).ok) continue;
      ++compared;
      const std::vector<double> expected = enumerate->solve(problem, Budget{}).x;
      for (const JpdaOptions& way : all_ways()) {
        expect_close(make_jpda(way)->solve(problem, Budget{}).x, expected, 1e-12);
      }
    }
  }
  EXPECT_GE(compared, 250);
}

/// Masking the tracks and masking the plots are two different programmes. These are beyond
/// enumeration.
TEST(Jpda, MasksOfEitherSideAgree) {
  const std::array shapes = {
      ScanShape{.tracks = 12, .plots = 14},
      ScanShape{.tracks = 9, .plots = 15, .spread_nats = 60.0},
      ScanShape{.tracks = 60, .plots = 90, .length = 60.0, .gate = 2.0},
      ScanShape{.tracks = 40, .plots = 50, .length = 20.0, .height = 20.0, .gate = 2.2}};
  const auto tracks = make_jpda({.masked = Masked::kTracks});
  const auto plots = make_jpda({.masked = Masked::kPlots});
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const ScanShape& shape : shapes) {
      SCOPED_TRACE(seed);
      const AssociationProblem problem = random_scan(shape, seed);
      const Solution a = tracks->solve(problem, Budget{});
      const Solution b = plots->solve(problem, Budget{});
      if (a.x.empty() || b.x.empty()) continue;
      ++compared;
      expect_close(a.x, b.x, 1e-12);
    }
  }
  EXPECT_GE(compared, 15);
}

/// Row of a track of the published example: likelihood ratios of three plots, of a miss, and what
/// is to come out, as far as printed.
struct PublishedTrack {
  std::array<double, 3> ratio;
  double missed;
  std::array<double, 4> beta;
};

/// calc2DAssignmentProbs of the Tracker Component Library 6.1.1, run once in Octave
/// for three targets and three plots, exact method.
TEST(Jpda, ReproducesTheTrackerComponentLibrary) {
  const std::array<PublishedTrack, 3> tracks = {
      {{{0.5, 0.2, 0.0}, 0.3, {0.4525, 0.1254, 0.0, 0.4220}},
       {{0.4, 0.6, 0.1}, 0.2, {0.2294, 0.4731, 0.0573, 0.2401}},
       {{0.0, 0.3, 0.7}, 0.4, {0.0, 0.0968, 0.5520, 0.3513}}}};
  ProblemBuilder builder;
  for (int t = 0; t < 3; ++t) builder.add_row(0, RowUse::kExactlyOnce);
  for (int j = 0; j < 3; ++j) builder.add_row(1, RowUse::kAtMostOnce);
  std::vector<double> expected;
  for (int t = 0; t < 3; ++t) {
    const PublishedTrack& track = tracks[static_cast<std::size_t>(t)];
    for (int j = 0; j < 3; ++j) {
      const double ratio = track.ratio[static_cast<std::size_t>(j)];
      if (ratio == 0.0) continue;
      builder.add_column(-std::log(ratio), std::vector{t, 3 + j});
      expected.push_back(track.beta[static_cast<std::size_t>(j)]);
    }
    builder.add_column(-std::log(track.missed), std::vector{t});
    expected.push_back(track.beta[3]);
  }
  expect_close(make_jpda({})->solve(builder.build(), Budget{}).x, expected, 5e-5);
}

TEST(Jpda, TheExampleOfLeeAndJeongHasEightEvents) {
  const AssociationProblem& free = testing::tiny_problem("two gates").problem;
  EXPECT_EQ(make_jpda_enumerate()->solve(free, Budget{}).stats.nodes, 8);
  EXPECT_EQ(gibbs_distribution(free).choices, 8);
  const AssociationProblem& forced = testing::tiny_problem("two gates that must").problem;
  EXPECT_EQ(gibbs_distribution(forced).choices, 3);
  EXPECT_FALSE(make_jpda({})->can_solve(forced.shape()).ok);
}

/// Three tracks that all but must be in a pair, two plots: the odds are those of the costs'
/// differences, whatever the costs.
TEST(Jpda, OddsDependOnDifferencesOnly) {
  const std::array<double, 6> difference = {0.0, 1.0, -0.5, 2.0, 0.25, -1.0};
  std::vector<double> expected;
  for (const double level : {-40.0, -700.0, -2000.0, -1e6}) {
    SCOPED_TRACE(level);
    ProblemBuilder builder;
    for (int t = 0; t < 3; ++t) builder.add_row(0, RowUse::kAtMostOnce);
    for (int j = 0; j < 2; ++j) builder.add_row(1, RowUse::kAtMostOnce);
    for (int i = 0; i < 6; ++i) {
      builder.add_column(level + difference[static_cast<std::size_t>(i)],
                         std::vector{i / 2, 3 + i % 2});
    }
    for (const JpdaOptions& way : all_ways()) {
      const std::vector<double> x = make_jpda(way)->solve(builder.build(), Budget{}).x;
      if (expected.empty()) expected = x;
      expect_close(x, expected, 1e-9);
    }
    expect_close(make_jpda_enumerate()->solve(builder.build(), Budget{}).x, expected, 1e-9);
  }
}

TEST(Jpda, HopelessPairsHaveNoProbability) {
  for (const double cost : {700.0, 2000.0, 1e9}) {
    ProblemBuilder builder;
    for (int t = 0; t < 2; ++t) builder.add_row(0, RowUse::kAtMostOnce);
    builder.add_row(1, RowUse::kAtMostOnce);
    for (int t = 0; t < 2; ++t) builder.add_column(cost, std::vector{t, 2});
    for (const double x : make_jpda({})->solve(builder.build(), Budget{}).x) {
      EXPECT_GE(x, 0.0);
      EXPECT_LE(x, 1e-300);
    }
  }
}

TEST(Jpda, WithoutTracksOrPlotsThereIsNothingToSay) {
  for (const int tracks : {0, 3}) {
    for (const int plots : {0, 3}) {
      ScanShape shape{.tracks = tracks, .plots = plots, .gate = 0.0};
      const Solution solution = make_jpda({})->solve(random_scan(shape, 1), Budget{});
      EXPECT_EQ(solution.status, Status::kFeasible);
      EXPECT_TRUE(solution.x.empty());
    }
  }
}

TEST(Jpda, BeyondTheCapThereIsNoAnswerButAReason) {
  const AssociationProblem problem = random_scan({.tracks = 9, .plots = 10}, 1);
  for (const JpdaOptions& options :
       {JpdaOptions{.most_masked = 8}, JpdaOptions{.most_bytes = 1e4}}) {
    const Solution solution = make_jpda(options)->solve(problem, Budget{});
    EXPECT_EQ(solution.status, Status::kNoAnswer);
    EXPECT_EQ(solution.stop, Stop::kFinished);
    EXPECT_TRUE(solution.x.empty());
    EXPECT_NE(solution.note.find("frontier of 9 rows"), std::string::npos) << solution.note;
    EXPECT_NE(solution.note.find("lbp"), std::string::npos) << solution.note;
  }
  EXPECT_EQ(make_jpda({.most_masked = 9})->solve(problem, Budget{}).status, Status::kFeasible);
}

TEST(Jpda, StopsInTheMiddleOfALongSum) {
  const AssociationProblem problem = random_scan({.tracks = 18, .plots = 40}, 1);
  Budget budget;
  budget.deadline = Clock::now() + std::chrono::milliseconds(1);
  const Solution solution = make_jpda({})->solve(problem, budget);
  EXPECT_EQ(solution.status, Status::kNoAnswer);
  EXPECT_EQ(solution.stop, Stop::kDeadline);
}

}  // namespace
}  // namespace mda
