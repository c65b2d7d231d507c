// The loop around the windows: deciding, sliding, estimating.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "scenarios/groups.h"
#include "scenarios/known/known_windows.h"
#include "scenarios/known/references.h"
#include "scenarios/testing/known.h"

namespace mda::testing {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

double mean_error_km(const std::vector<TargetState>& a, const std::vector<TargetState>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::hypot(a[i].x - b[i].x, a[i].y - b[i].y);
  return sum / static_cast<double>(a.size());
}

/// With every target seen in every scan, resolved, and given its own plots.
TEST(KnownWindowsLoopTest, AdvancingByTheTruthIsTheFilterOnTheTrueTracks) {
  for (const char* name : {"battistelli-1", "battistelli-2", "battistelli-2-radial"}) {
    SCOPED_TRACE(name);
    ScenarioSpec spec = *find_scenario(name);
    spec.world.detection_probability = 1.0 - 1e-9;
    spec.known_targets->resolution_range_km = 0.0;
    const StateHistory ideal = ideal_states(simulate_known(spec, kSeed, 1), spec);
    for (const int window_k : {1, 3}) {
      play_the_truth(spec, window_k, [&](const KnownTrackWindows& windows, const auto& tuples) {
        const int newest = windows.newest_scan();
        const auto& truth = windows.scene().scans[index(newest - 1)].truth;
        EXPECT_LT(mean_error_km(windows.estimates(tuples), truth), 0.3);
        EXPECT_LT(mean_error_km(windows.estimates(tuples), ideal[index(newest - 1)]), 1e-9);
        if (windows.fixed_scan() == 0) return;
        const auto& fixed = ideal[index(windows.fixed_scan() - 1)];
        EXPECT_LT(mean_error_km(windows.lagged_estimates(), fixed), 1e-9);
      });
    }
  }
}

TEST(KnownWindowsLoopTest, TrueDecisionsAreRight) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    play_the_truth(spec, 2, [&](const KnownTrackWindows& windows, const auto& tuples) {
      for (int k = 1; k <= windows.window_scans(); ++k) {
        const int scan = windows.newest_scan() - windows.window_scans() + k;
        const std::vector<int> plots = windows.decisions(tuples, k);
        for (int track = 0; track < windows.tracks(); ++track) {
          EXPECT_TRUE(is_right(windows.scene().scans[index(scan - 1)], plots, track));
        }
      }
    });
  }
}

TEST(KnownWindowsLoopTest, ViewsOutliveTheWindows) {
  AssociationProblem problem;
  std::vector<Tuple> tuples;
  double cost = 0.0;
  {
    KnownTrackWindows windows(*find_scenario("battistelli-2"), kSeed, 1, 2);
    ASSERT_TRUE(windows.next());
    problem = windows.window().problem;
    tuples = true_sequences(windows);
    cost = problem.views()->tuple_cost(tuples[0]);
    windows.advance(tuples);
    ASSERT_TRUE(windows.next());
  }
  EXPECT_EQ(problem.views()->tuple_cost(tuples[0]), cost);
}

TEST(KnownWindowsLoopTest, EstimatesAreTheSameBeforeAndAfterAdvancing) {
  KnownTrackWindows windows(*find_scenario("battistelli-1"), kSeed, 1, 1);
  ASSERT_TRUE(windows.next());
  const std::vector<Tuple> tuples = true_sequences(windows);
  const auto before = windows.estimates(tuples);
  windows.advance(tuples);
  EXPECT_EQ(mean_error_km(windows.estimates(tuples), before), 0.0);
  EXPECT_EQ(mean_error_km(windows.lagged_estimates(), before), 0.0) << "K = 1";
}

TEST(KnownWindowsLoopTest, RefusesWhatIsNoAnswer) {
  const ScenarioSpec& spec = *find_scenario("battistelli-2");
  EXPECT_THROW(KnownTrackWindows(*find_scenario("A"), kSeed, 1, 2), std::invalid_argument);
  EXPECT_THROW(KnownTrackWindows(spec, kSeed, 1, 0), std::invalid_argument);
  KnownTrackWindows windows(spec, kSeed, 1, 1);
  EXPECT_THROW(windows.advance({}), std::invalid_argument) << "no window yet";
  ASSERT_TRUE(windows.next());
  EXPECT_THROW(static_cast<void>(windows.next()), std::logic_error);
  const std::vector<Tuple> right = true_sequences(windows);
  const auto refuses = [&](auto spoil) {
    std::vector<Tuple> tuples = right;
    spoil(tuples);
    EXPECT_THROW(windows.advance(tuples), std::invalid_argument);
  };
  refuses([](auto& tuples) { tuples.pop_back(); });
  refuses([](auto& tuples) { tuples[1].track = 0; });
  refuses([](auto& tuples) { tuples[1].track = 3; });
  refuses([](auto& tuples) { tuples[1].rows.push_back(kNoRow); });
  refuses([](auto& tuples) { tuples[1].rows[0] = 0; });
  refuses([](auto& tuples) { tuples[1].rows[0] = 1000; });
  EXPECT_EQ(windows.fixed_scan(), 0);
  windows.advance(right);
  EXPECT_EQ(windows.fixed_scan(), 1);
}

}  // namespace
}  // namespace mda::testing
