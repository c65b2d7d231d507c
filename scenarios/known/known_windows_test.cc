#include "scenarios/known/known_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/testing/tree_laws.h"
#include "scenarios/groups.h"
#include "scenarios/testing/by_the_book.h"
#include "scenarios/testing/known.h"

namespace mda::testing {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Scan counts that end amid what is hard: platoons in each other, the first meeting.
int hard_scans(const ScenarioSpec& spec) {
  return spec.known_targets->trajectories == Trajectories::kPlatoons ? 36 : 84;
}

TEST(KnownWindowsTest, TreesObeyTheirLaws) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    for (int window_k = 1; window_k <= 4; ++window_k) {
      SCOPED_TRACE(spec.name + ", K = " + std::to_string(window_k));
      int seen = 0;
      play_the_truth(cut_short(spec, hard_scans(spec)), window_k,
                     [&](const KnownTrackWindows& windows, const auto&) {
                       ++seen;
                       ASSERT_EQ(windows.window_scans(), std::min(seen, window_k));
                       ASSERT_EQ(windows.newest_scan(), seen);
                       if (seen % 4 != 0 && seen > window_k) return;
                       const AssociationProblem& problem = windows.window().problem;
                       expect_lawful_tree(problem);
                       expect_tuple_cost_of_columns(problem, 1e-9);
                     });
      EXPECT_EQ(seen, hard_scans(spec));
    }
  }
}

TEST(KnownWindowsTest, ShapeIsThatOfKnownTracks) {
  play_the_truth(cut_short(*find_scenario("battistelli-1"), 12), 3,
                 [](const KnownTrackWindows& windows, const auto&) {
                   const Shape& shape = windows.window().problem.shape();
                   EXPECT_TRUE(shape.known_tracks);
                   EXPECT_TRUE(shape.has_tree);
                   EXPECT_TRUE(shape.always_feasible);
                   EXPECT_EQ(shape.dimensions, windows.window_scans() + 1);
                   double ungated = windows.tracks();
                   int rows = windows.tracks();
                   for (int k = 0; k < windows.window_scans(); ++k) {
                     const auto& scan = windows.scene().scans[index(windows.newest_scan() - 1 - k)];
                     ungated *= static_cast<double>(scan.plots.size() + 1);
                     rows += static_cast<int>(scan.plots.size());
                   }
                   EXPECT_EQ(shape.rows, rows);
                   EXPECT_EQ(windows.window().ungated_columns, ungated);
                   const std::vector<double> coasting = coasting_costs(windows.window().problem);
                   for (int row = 0; row < rows; ++row) {
                     const auto use = windows.window().problem.use(row);
                     EXPECT_EQ(use,
                               row < windows.tracks() ? RowUse::kExactlyOnce : RowUse::kAtMostOnce);
                   }
                   EXPECT_EQ(static_cast<int>(coasting.size()), rows);
                 });
}

/// The first windows, whose base is the given estimate.
TEST(KnownWindowsTest, ColumnsAreAllGatedSequencesAtTheirCost) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    SCOPED_TRACE(spec.name);
    KnownTrackWindows windows(spec, kSeed, 2, 4);
    for (int scan = 1; scan <= 4; ++scan) {
      ASSERT_TRUE(windows.next());
      const AssociationProblem& problem = windows.window().problem;
      std::map<std::pair<int, std::vector<int>>, double> costs;
      std::vector<int> columns(index(problem.columns()));
      std::iota(columns.begin(), columns.end(), 0);
      const std::vector<Tuple> sequences = windows.sequences_of(columns);
      for (int j = 0; j < problem.columns(); ++j) {
        costs[{sequences[index(j)].track, sequences[index(j)].rows}] = problem.cost(j);
      }
      std::size_t count = 0;
      every_gated_sequence(spec, windows, [&](const Tuple& tuple, double cost) {
        ++count;
        const auto found = costs.find({tuple.track, tuple.rows});
        ASSERT_NE(found, costs.end());
        EXPECT_NEAR(found->second, cost, 1e-7);
        EXPECT_NEAR(problem.views()->tuple_cost(tuple), cost, 1e-7);
      });
      EXPECT_EQ(count, costs.size());
      windows.advance(true_sequences(windows));
      EXPECT_EQ(windows.fixed_scan(), scan < 4 ? 0 : 1);
    }
  }
}

struct Totals {
  double true_plot = 0.0;        ///< mean cost of a target's own plot, beyond that of a miss
  double miss_is_cheaper = 0.0;  ///< share of windows in which all-missed beats the truth
};

Totals totals_of(const char* name, CostNormalisation normalisation) {
  ScenarioSpec spec = *find_scenario(name);
  spec.known_targets->normalisation = normalisation;
  Totals totals;
  double plots = 0.0;
  double number = 0.0;
  play_the_truth(spec, 2, [&](const KnownTrackWindows& windows, const auto& tuples) {
    const TupleCost& cost = windows.window().problem.views()->tuple_cost;
    double true_total = 0.0;
    for (const Tuple& tuple : tuples) {
      const Tuple missed{tuple.track, std::vector<int>(tuple.rows.size(), kNoRow)};
      true_total += cost(tuple) - cost(missed);
      for (const int row : tuple.rows) plots += row == kNoRow ? 0.0 : 1.0;
    }
    totals.true_plot += true_total;
    totals.miss_is_cheaper += true_total > 0.0 ? 1.0 : 0.0;
    number += 1.0;
  });
  totals.true_plot /= plots;
  totals.miss_is_cheaper /= number;
  return totals;
}

/// Why the likelihood is divided by the density of clutter.
TEST(KnownWindowsTest, OnlyARatioOfLikelihoodsPrefersTheTruth) {
  for (const char* name : {"battistelli-1", "battistelli-2", "battistelli-2-radial"}) {
    SCOPED_TRACE(name);
    const Totals ratio = totals_of(name, CostNormalisation::kClutterDensity);
    EXPECT_LT(ratio.true_plot, -5.0);
    EXPECT_LT(ratio.miss_is_cheaper, 0.05);
    const Totals literal = totals_of(name, CostNormalisation::kLiteral);
    EXPECT_GT(literal.true_plot, 0.0);
    EXPECT_GT(literal.miss_is_cheaper, 0.5);
  }
}

TEST(KnownWindowsTest, WithoutClutterCostsAreFinite) {
  ScenarioSpec spec = cut_short(*find_scenario("battistelli-2"), 5);
  spec.world.clutter_per_scan = 0.0;
  play_the_truth(spec, 2, [](const KnownTrackWindows& windows, const auto& tuples) {
    for (const Tuple& tuple : tuples) {
      EXPECT_TRUE(std::isfinite(windows.window().problem.views()->tuple_cost(tuple)));
    }
  });
}

}  // namespace
}  // namespace mda::testing
