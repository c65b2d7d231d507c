#include "scenarios/world/simulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "scenarios/groups.h"
#include "scenarios/testing/known.h"
#include "scenarios/testing/scenes.h"

namespace mda {

// Found by argument-dependent lookup, so they stand beside what they compare.
static bool operator==(const Plot& a, const Plot& b) {
  return a.range_km == b.range_km && a.bearing_rad == b.bearing_rad && a.source == b.source;
}
static bool operator==(const TruePosition& a, const TruePosition& b) {
  return a.target == b.target && a.state.x == b.state.x && a.state.vx == b.state.vx &&
         a.state.y == b.state.y && a.state.vy == b.state.vy;
}
static bool operator==(const Scan& a, const Scan& b) {
  return a.plots == b.plots && a.truth == b.truth;
}

namespace testing {
namespace {

constexpr std::uint64_t kSeed = 1;

TEST(SimulateTest, SameKeySameScene) {
  for (const ScenarioSpec& spec : storms_groups()) {
    const Scene a = simulate(spec, kSeed, 3);
    const Scene b = simulate(spec, kSeed, 3);
    EXPECT_EQ(a.scans, b.scans);
    EXPECT_EQ(a.targets, b.targets);
    EXPECT_EQ(a.scans.size(), 30u);
  }
}

TEST(SimulateTest, OtherKeyOtherScene) {
  const ScenarioSpec& spec = *find_scenario("B");
  const Scene scene = simulate(spec, kSeed, 3);
  EXPECT_NE(simulate(spec, kSeed, 4).scans, scene.scans);
  EXPECT_NE(simulate(spec, kSeed + 1, 3).scans, scene.scans);
  ScenarioSpec renamed = spec;
  renamed.name = "other";
  EXPECT_NE(simulate(renamed, kSeed, 3).scans, scene.scans);
}

TEST(SimulateTest, TheTrackersModelDoesNotMatter) {
  ScenarioSpec spec = *find_scenario("C");
  const Scene scene = simulate(spec, kSeed, 1);
  spec.model.gate = 1.0;
  spec.model.rows = RowRule::kEquality;
  EXPECT_EQ(simulate(spec, kSeed, 1).scans, scene.scans);
}

TEST(SimulateTest, PlotsAreInTheOrderOfTheirRange) {
  for (const ScenarioSpec& spec : storms_groups()) {
    for (const Scan& scan : simulate(spec, kSeed, 1).scans) {
      EXPECT_TRUE(std::ranges::is_sorted(scan.plots, {}, &Plot::range_km));
      for (const Plot& plot : scan.plots) EXPECT_LE(std::abs(plot.bearing_rad), std::numbers::pi);
    }
  }
}

TEST(SimulateTest, NoTargetHasTwoPlotsInAScan) {
  for (const Scan& scan : simulate(*find_scenario("D"), kSeed, 1).scans) {
    std::set<int> seen;
    for (const Plot& plot : scan.plots) {
      if (plot.source != kFalseAlarm) {
        EXPECT_TRUE(seen.insert(plot.source).second) << "target " << plot.source;
      }
    }
  }
}

TEST(SimulateTest, UnderAnotherScanPeriodOnlyTheMotionChanges) {
  const ScenarioSpec& slow = *find_scenario("B");
  ScenarioSpec fast = slow;
  fast.world.scan_period_s = 2.0;
  const Scene a = simulate(slow, kSeed, 2);
  const Scene b = simulate(fast, kSeed, 2);
  ASSERT_EQ(a.targets, b.targets);
  int seen_in_both = 0;
  int known = 0;
  for (std::size_t scan = 0; scan < a.scans.size(); ++scan) {
    ASSERT_EQ(a.scans[scan].truth.size(), b.scans[scan].truth.size());
    for (std::size_t i = 0; i < a.scans[scan].truth.size(); ++i) {
      const TruePosition& in_a = a.scans[scan].truth[i];
      const TruePosition& in_b = b.scans[scan].truth[i];
      ASSERT_EQ(in_a.target, in_b.target);
      if (in_a.target >= known) {
        EXPECT_EQ(in_a, in_b) << "born elsewhere";
        known = in_a.target + 1;
      }
      if (range_of(in_a.state) > 50.0 || range_of(in_b.state) > 50.0) continue;
      const bool in_plots = plot_of(a.scans[scan], in_a.target) != nullptr;
      EXPECT_EQ(in_plots, plot_of(b.scans[scan], in_a.target) != nullptr);
      seen_in_both += in_plots ? 1 : 0;
    }
    const auto false_alarms = [](const Scan& s) {
      std::vector<Plot> found;
      std::ranges::copy_if(s.plots, std::back_inserter(found),
                           [](const Plot& plot) { return plot.source == kFalseAlarm; });
      return found;
    };
    EXPECT_EQ(false_alarms(a.scans[scan]), false_alarms(b.scans[scan]));
  }
  EXPECT_GT(seen_in_both, 100);
}

TEST(SimulateTest, TargetsVanishAfterTheirLife) {
  ScenarioSpec spec = *find_scenario("D");
  spec.world.target_life_scans = 5;
  const Scene scene = simulate(spec, kSeed, 1);
  std::map<int, std::vector<int>> scans_of_target;
  for (int scan = 1; scan <= static_cast<int>(scene.scans.size()); ++scan) {
    const Scan& now = scene.scans[static_cast<std::size_t>(scan) - 1];
    for (const TruePosition& position : now.truth) {
      scans_of_target[position.target].push_back(scan);
    }
    for (const Plot& plot : now.plots) {
      if (plot.source != kFalseAlarm) {
        EXPECT_NE(truth_of(now, plot.source), nullptr);
      }
    }
  }
  EXPECT_EQ(static_cast<int>(scans_of_target.size()), scene.targets);
  for (const auto& [target, scans] : scans_of_target) {
    EXPECT_EQ(static_cast<int>(scans.size()), std::min(5, 30 - scans.front() + 1));
    EXPECT_EQ(scans.back() - scans.front() + 1, static_cast<int>(scans.size()));
  }
}

}  // namespace
}  // namespace testing
}  // namespace mda
