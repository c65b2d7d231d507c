#include "scenarios/hypotheses/extract.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "algorithms/testing/draw.h"
#include "scenarios/groups.h"
#include "scenarios/testing/choices.h"
#include "scenarios/world/simulate.h"

namespace mda::testing {
namespace {

/// Grows a scene and lets `check(forest, window)` look at every window.
template <typename Check>
void for_every_window(const ScenarioSpec& spec, int window_k, const Check& check) {
  TrackForest forest;
  WindowExtractor extractor;
  forest.reset(spec.world, spec.model, window_k);
  for (const Scan& scan : simulate(spec, 1, 2).scans) {
    forest.grow(scan);
    SCOPED_TRACE(spec.name + ", K = " + std::to_string(window_k) + ", scan " +
                 std::to_string(forest.newest_scan()));
    const WindowInstance window = extractor.extract(forest);
    check(forest, window);
    forest.decide(leaves_of(window, cheapest_that_fit(window.problem)));
  }
}

/// First scan of the window, by the rule of the paper: model (9) up to scan K + 1, then (13).
int first_scan(int newest, int window_k) {
  return newest <= window_k + 1 ? 1 : newest - window_k + 1;
}

TEST(ExtractTest, RowsAreTracksThenThePlotsOfEachScan) {
  for (const int window_k : {2, 3, 5}) {
    for_every_window(*find_scenario("C"), window_k, [&](const TrackForest& forest, const auto& w) {
      int row = 0;
      for (; row < forest.tracks(); ++row) EXPECT_EQ(w.problem.dimension(row), 0);
      const int first = first_scan(forest.newest_scan(), window_k);
      for (int scan = first; scan <= forest.newest_scan(); ++scan) {
        for (int plot = 0; plot < forest.plots(scan); ++plot, ++row) {
          EXPECT_EQ(w.problem.dimension(row), scan - first + 1);
          EXPECT_EQ(w.problem.use(row), RowUse::kAtMostOnce);
        }
      }
      EXPECT_EQ(row, w.problem.rows());
    });
  }
}

TEST(ExtractTest, DimensionsAreKPlusOneOnceTracksAreFixed) {
  for (const int window_k : {1, 2, 3, 5}) {
    for_every_window(*find_scenario("A"), window_k, [&](const TrackForest& forest, const auto& w) {
      const int newest = forest.newest_scan();
      EXPECT_EQ(w.problem.shape().dimensions, std::min(newest, window_k + 1));
      EXPECT_EQ(forest.fixed_scan(), first_scan(newest, window_k) - 1);
    });
  }
}

/// |Z^K|: one of the tracks or none, and of each scan one of the plots or none, but never nothing.
TEST(ExtractTest, UngatedColumns) {
  for (const int window_k : {2, 5}) {
    for_every_window(*find_scenario("B"), window_k, [&](const TrackForest& forest, const auto& w) {
      std::vector<double> entries(static_cast<std::size_t>(w.problem.shape().dimensions) + 1, 1.0);
      for (int row = 0; row < w.problem.rows(); ++row) {
        entries[static_cast<std::size_t>(w.problem.dimension(row))] += 1.0;
      }
      const double all = std::accumulate(entries.begin(), entries.end(), 1.0, std::multiplies<>());
      EXPECT_DOUBLE_EQ(w.ungated_columns, all - 1.0);
      EXPECT_LE(w.problem.columns(), w.ungated_columns);
      EXPECT_EQ(w.retired_nats, forest.retired_cost());
    });
  }
}

TEST(ExtractTest, ColumnsAreTheLeavesThatGainAndHavePlotsEnough) {
  for (const Newborn newborn : {Newborn::kTwoPlots, Newborn::kSinglePlot}) {
    ScenarioSpec spec = *find_scenario("D");
    spec.model.newborn = newborn;
    for_every_window(spec, 3, [&](const TrackForest& forest, const auto& w) {
      std::vector<int> expected;
      for (int i = 0; i < static_cast<int>(forest.leaves().size()); ++i) {
        const Leaf& leaf = forest.leaves()[static_cast<std::size_t>(i)];
        const bool enough = leaf.plots >= 2 || newborn == Newborn::kSinglePlot;
        if (enough && forest.column_cost(leaf) < 0.0) expected.push_back(i);
      }
      EXPECT_EQ(w.leaf_of_column, expected);
      for (int column = 0; column < w.problem.columns(); ++column) {
        const int leaf = w.leaf_of_column[static_cast<std::size_t>(column)];
        EXPECT_EQ(w.problem.cost(column),
                  forest.column_cost(forest.leaves()[static_cast<std::size_t>(leaf)]));
      }
    });
  }
}

/// The equality windows are the packing windows and one free column for each row. So a packing
/// becomes a partition of the same cost by adding the free columns of the rows that it leaves, and
/// a partition a packing by leaving them out: the optima are equal.
TEST(ExtractTest, EqualityAddsOneFreeColumnForEachRow) {
  ScenarioSpec packing = *find_scenario("D");
  packing.world.scans = 15;
  ScenarioSpec equality = packing;
  equality.model.rows = RowRule::kEquality;
  std::vector<AssociationProblem> packings;
  for_every_window(packing, 3, [&](const auto&, const auto& w) { packings.push_back(w.problem); });
  std::size_t next = 0;
  for_every_window(equality, 3, [&](const auto&, const auto& w) {
    const AssociationProblem& of_packing = packings.at(next++);
    const AssociationProblem& problem = w.problem;
    ASSERT_EQ(problem.rows(), of_packing.rows());
    ASSERT_EQ(problem.columns(), of_packing.columns() + problem.rows());
    ASSERT_EQ(w.leaf_of_column.size(), static_cast<std::size_t>(problem.columns()));
    for (int column = 0; column < of_packing.columns(); ++column) {
      EXPECT_EQ(problem.cost(column), of_packing.cost(column));
      EXPECT_TRUE(std::ranges::equal(problem.rows_of(column), of_packing.rows_of(column)));
    }
    for (int row = 0; row < problem.rows(); ++row) {
      const int alone = of_packing.columns() + row;
      EXPECT_EQ(problem.use(row), RowUse::kExactlyOnce);
      EXPECT_EQ(problem.cost(alone), 0.0);
      EXPECT_TRUE(std::ranges::equal(problem.rows_of(alone), std::vector<int>{row}));
      EXPECT_EQ(w.leaf_of_column[static_cast<std::size_t>(alone)], -1);
    }
    EXPECT_TRUE(problem.shape().always_feasible);
  });
  EXPECT_EQ(next, packings.size());
}

}  // namespace
}  // namespace mda::testing
