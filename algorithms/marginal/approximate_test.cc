// The marginals that are approximations: when they are exact, and how far off they may be.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "algorithms/marginal/jpda.h"
#include "algorithms/marginal/jpda_cheap.h"
#include "algorithms/marginal/lbp.h"
#include "algorithms/marginal/pda.h"
#include "algorithms/testing/draw.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_scans.h"

namespace mda {
namespace {

using testing::random_scan;
using testing::ScanShape;

void expect_close(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t j = 0; j < a.size(); ++j) EXPECT_NEAR(a[j], b[j], tolerance) << "column " << j;
}

std::vector<double> solve(Associator& algorithm, const AssociationProblem& problem) {
  return algorithm.solve(problem, Budget{}).x;
}

/// A tree of tracks and plots in turn, with columns alone and tracks that must here and there.
AssociationProblem random_tree(std::uint64_t seed) {
  testing::Draw draw(seed);
  ProblemBuilder builder;
  std::vector<int> tracks;
  std::vector<int> plots;
  const auto cost = [&] { return 12.0 * draw.unit() - 8.0; };
  const int rows = 2 + draw.below(14);
  for (int i = 0; i < rows; ++i) {
    const bool track = i == 0 || (i > 1 && draw.chance(0.5));
    const bool must = track && draw.chance(0.3);
    const int row =
        builder.add_row(track ? 0 : 1, must ? RowUse::kExactlyOnce : RowUse::kAtMostOnce);
    if (must || draw.chance(0.2)) builder.add_column(cost(), std::vector{row});
    std::vector<int>& partners = track ? plots : tracks;
    if (!partners.empty()) {
      const auto partner = static_cast<std::size_t>(draw.below(static_cast<int>(partners.size())));
      builder.add_column(cost(), std::vector{row, partners[partner]});
    }
    (track ? tracks : plots).push_back(row);
  }
  return builder.build();
}

TEST(Lbp, IsExactOnTrees) {
  const auto jpda = make_jpda({});
  const auto lbp = make_lbp({});
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_tree(seed);
    expect_close(solve(*lbp, problem), solve(*jpda, problem), 1e-6);
  }
}

/// How far the methods are from the truth, added up over the columns of scans in which every plot
/// is in several gates.
TEST(Lbp, IsNearerToTheTruthThanTheOthers) {
  const auto jpda = make_jpda({});
  const auto error = [&](Associator& algorithm) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const AssociationProblem problem =
          random_scan({.tracks = 8, .plots = 10, .length = 4.0, .spread_nats = 3.0}, seed);
      const std::vector<double> truth = solve(*jpda, problem);
      const std::vector<double> answer = solve(algorithm, problem);
      for (std::size_t j = 0; j < truth.size(); ++j) sum += std::abs(truth[j] - answer[j]);
    }
    return sum;
  };
  const double lbp = error(*make_lbp({}));
  EXPECT_LT(3.0 * lbp, error(*make_jpda_cheap()));
  EXPECT_LT(3.0 * lbp, error(*make_pda()));
}

/// The rule for stopping promises how far the beliefs are from their limit.
TEST(Lbp, StopsAsNearToItsLimitAsItSays) {
  const auto limit = make_lbp({.tolerance = 1e-12, .most_iterations = 1000000});
  for (const double tolerance : {1e-1, 1e-3, 1e-6}) {
    const auto lbp = make_lbp({.tolerance = tolerance});
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      SCOPED_TRACE(seed);
      const AssociationProblem problem = random_scan({.tracks = 6, .plots = 7}, seed);
      const Solution solution = lbp->solve(problem, Budget{});
      ASSERT_EQ(solution.stop, Stop::kFinished);
      const std::vector<double> end = solve(*limit, problem);
      for (std::size_t j = 0; j < end.size(); ++j) {
        EXPECT_NEAR(solution.x[j], end[j], tolerance * end[j] + 1e-11);
      }
    }
  }
}

TEST(Lbp, CountsItsIterationsAndSaysWhenThereWereTooFew) {
  const AssociationProblem problem = random_scan({.tracks = 6, .plots = 7}, 1);
  const Solution enough = make_lbp({})->solve(problem, Budget{});
  EXPECT_EQ(enough.stop, Stop::kFinished);
  EXPECT_GE(enough.stats.iterations, 3);
  const Solution few = make_lbp({.most_iterations = 2})->solve(problem, Budget{});
  EXPECT_EQ(few.stop, Stop::kIterationLimit);
  EXPECT_EQ(few.stats.iterations, 2);
  EXPECT_EQ(few.status, Status::kFeasible);
}

/// In the limit a plot's probabilities add up to 1 at most, as a track's do always.
TEST(Lbp, IsConsistentInTheLimit) {
  const auto lbp = make_lbp({});
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_scan({.tracks = 9, .plots = 5}, seed);
    EXPECT_LE(testing::row_violation(problem, solve(*lbp, problem)), 1e-5);
  }
}

TEST(Lbp, BearsCostsOfAnySize) {
  for (const double spread : {700.0, 1e5, 1e9}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(seed);
      const AssociationProblem problem =
          random_scan({.tracks = 5, .plots = 4, .spread_nats = spread}, seed);
      for (const auto& algorithm :
           {make_lbp({.most_iterations = 2000}), make_jpda_cheap(), make_pda(), make_jpda({})}) {
        for (const double x : solve(*algorithm, problem)) EXPECT_TRUE(x >= 0.0 && x <= 1.0) << x;
      }
    }
  }
}

TEST(ApproximateMarginals, AreAllExactForATrackWithoutRivals) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    ScanShape shape{.tracks = 1, .plots = 1 + static_cast<int>(seed % 6)};
    shape.spread_nats = seed % 2 == 0 ? 8.0 : 800.0;
    const AssociationProblem problem = random_scan(shape, seed);
    const std::vector<double> truth = solve(*make_jpda({}), problem);
    expect_close(solve(*make_pda(), problem), truth, 1e-12);
    expect_close(solve(*make_jpda_cheap(), problem), truth, 1e-12);
    expect_close(solve(*make_lbp({}), problem), truth, 1e-6);
  }
}

/// Two sure tracks, one plot: pda gives it to both.
TEST(Pda, DoesNotKnowOfRivals) {
  ProblemBuilder builder;
  builder.add_row(0, RowUse::kAtMostOnce);
  builder.add_row(0, RowUse::kAtMostOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_column(-std::log(4.0), std::vector{0, 2});
  builder.add_column(-std::log(4.0), std::vector{1, 2});
  expect_close(solve(*make_pda(), builder.build()), {0.8, 0.8}, 1e-12);
  expect_close(solve(*make_jpda_cheap(), builder.build()), {4.0 / 9.0, 4.0 / 9.0}, 1e-12);
  expect_close(solve(*make_jpda({}), builder.build()), {4.0 / 9.0, 4.0 / 9.0}, 1e-12);
}

}  // namespace
}  // namespace mda
