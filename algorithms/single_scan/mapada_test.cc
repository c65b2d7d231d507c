#include "algorithms/single_scan/mapada.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "algorithms/single_scan/gnn.h"
#include "algorithms/single_scan/mapada_miss.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_pair_scans.h"
#include "algorithms/testing/random_problems.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

testing::PairScanShape crowded(std::uint64_t seed) {
  testing::PairScanShape shape = testing::random_pair_scan_shape(seed);
  shape.side_km = 0.5;
  return shape;
}

/// mapada_miss.h says by how much they may differ.
void expect_like_gnn(const AssociationProblem& problem) {
  const Solution mapada = make_mapada_miss()->solve(problem, Budget{});
  const Solution gnn = make_gnn()->solve(problem, Budget{});
  ASSERT_EQ(mapada.status, Status::kFeasible);
  EXPECT_EQ(mapada.stop, Stop::kFinished);
  EXPECT_EQ(testing::row_violation(problem, mapada), 0.0);
  double largest = 0.0;
  for (const double cost : problem.costs()) largest = std::max(largest, std::abs(cost));
  const double largest_gain = 3.0 * largest;  // a pair against two rows alone
  const double margin = 12.0 * problem.rows() * kMapadaMissTolerance * largest_gain;
  EXPECT_NEAR(testing::cost_of(problem, mapada), testing::cost_of(problem, gnn), margin);
}

TEST(MapadaMiss, IsGnnOnScans) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    expect_like_gnn(testing::random_pair_scan(crowded(seed), seed));
  }
}

TEST(MapadaMiss, IsGnnOnProblemsWithColumnsOfAllKinds) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomShape shape;
    shape.dimensions = 2;
    shape.rows_per_dimension = 1 + static_cast<int>(seed % 6);
    shape.columns = 20;
    shape.tracks = seed % 2 == 0;
    shape.exactly_once = 0.25 * static_cast<double>(seed % 5);
    shape.integer_costs = seed % 7 == 0;
    shape.presence = 0.8;
    expect_like_gnn(testing::random_problem(shape, seed));
  }
}

TEST(MapadaMiss, TheUnitOfCostMovesNoStep) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = testing::random_pair_scan(crowded(seed), seed);
    const Solution a = make_mapada_miss()->solve(problem, Budget{});
    const Solution b = make_mapada_miss()->solve(testing::with_costs(problem, 64.0), Budget{});
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.stats.iterations, b.stats.iterations);
  }
}

/// One track and two plots, the one nearer to it, the other nearer to its line.
AssociationProblem one_track_two_plots() {
  ProblemBuilder builder;
  builder.add_row(0, RowUse::kExactlyOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_column(0.0, std::vector{0});
  builder.add_column(-1.0, std::vector{0, 1});
  builder.add_column(-2.0, std::vector{0, 2});
  PairView view;
  view.track_row = {0};
  view.plot_row = {1, 2};
  view.distance = {1.0, 4.0};
  view.line_distance = {0.04, 0.01};
  view.log_likelihood = {-1.0, -2.5};
  view.column = {1, 2};
  view.miss_column = {0};
  auto views = std::make_shared<Views>();
  views->pairs = view;
  AssociationProblem problem = builder.build();
  problem.attach(std::move(views));
  return problem;
}

TEST(Mapada, GoesByTheDistanceItIsTold) {
  const AssociationProblem problem = one_track_two_plots();
  const auto choice = [&](MapadaDistance distance) {
    return make_mapada({.distance = distance})->solve(problem, Budget{}).x;
  };
  EXPECT_EQ(choice(MapadaDistance::kVelocityLine), (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(choice(MapadaDistance::kMahalanobis), (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(choice(MapadaDistance::kColumnCost), (std::vector<double>{0, 0, 1}));
}

/// Two tracks in whose gates lies the same plot and no other: one gets it, the other none.
TEST(Mapada, TheLoserOfTheOnlyPlotGetsNone) {
  int lone_plots = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem =
        testing::random_pair_scan({.tracks = 2, .plots = 1, .side_km = 0.3}, seed);
    const PairView& view = *problem.views()->pairs;
    if (view.column[0] == kNoColumn || view.column[1] == kNoColumn) continue;
    ++lone_plots;
    const Solution solution = make_mapada()->solve(problem, Budget{});
    const int nearer = view.line_distance[0] < view.line_distance[1] ? 0 : 1;
    EXPECT_EQ(solution.x[index(view.column[index(nearer)])], 1.0);
    EXPECT_EQ(solution.x[index(view.miss_column[index(1 - nearer)])], 1.0);
  }
  EXPECT_GE(lone_plots, 50);
}

/// Every track has a plot or none: the answers of all decisions add up to 1 on its columns.
TEST(Mapada, EveryTrackAddsUpToOne) {
  int conflicts = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = testing::random_pair_scan(crowded(seed), seed);
    for (const MapadaDecision decision :
         {MapadaDecision::kAssignment, MapadaDecision::kArgmax, MapadaDecision::kWeighted}) {
      for (const bool clip : {true, false}) {
        const Solution solution = make_mapada({.decision = decision, .iteration = {.clip = clip}})
                                      ->solve(problem, Budget{});
        std::vector<double> used(index(problem.rows()), 0.0);
        for (int j = 0; j < problem.columns(); ++j) {
          for (const int r : problem.rows_of(j)) used[index(r)] += solution.x[index(j)];
        }
        for (int r = 0; r < problem.rows(); ++r) {
          if (problem.dimension(r) == 0) {
            EXPECT_NEAR(used[index(r)], 1.0, 1e-12);
          } else if (decision == MapadaDecision::kArgmax) {
            conflicts += used[index(r)] > 1.0 ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GE(conflicts, 50) << "the scans are too easy to tell the decisions apart";
}

}  // namespace
}  // namespace mda
