// The seed is fixed, so every test here gives the same answer each time. Bounds on statistics are
// about five standard errors, and narrower than what a parameter wrong by a fifth would shift.
#include "scenarios/world/simulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/groups.h"
#include "scenarios/world/draws.h"

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

using std::numbers::pi;

constexpr std::uint64_t kSeed = 1;

std::vector<Scene> replicates(const ScenarioSpec& spec, int count) {
  std::vector<Scene> scenes;
  for (int replicate = 1; replicate <= count; ++replicate) {
    scenes.push_back(simulate(spec, kSeed, replicate));
  }
  return scenes;
}

double range_of(const TargetState& state) { return std::hypot(state.x, state.y); }

const TruePosition* truth_of(const Scan& scan, int target) {
  const auto found = std::find_if(scan.truth.begin(), scan.truth.end(),
                                  [&](const TruePosition& t) { return t.target == target; });
  return found == scan.truth.end() ? nullptr : &*found;
}

/// Positions of all targets in the scan of their birth.
std::vector<TargetState> births(const std::vector<Scene>& scenes) {
  std::vector<TargetState> born;
  for (const Scene& scene : scenes) {
    int known = 0;
    for (const Scan& scan : scene.scans) {
      for (const TruePosition& position : scan.truth) {
        if (position.target < known) continue;
        born.push_back(position.state);
        known = position.target + 1;
      }
    }
    EXPECT_EQ(known, scene.targets);
  }
  return born;
}

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
};

Moments moments(const std::vector<double>& values) {
  Moments m;
  for (const double v : values) m.mean += v / static_cast<double>(values.size());
  for (const double v : values) {
    m.variance += (v - m.mean) * (v - m.mean) / static_cast<double>(values.size() - 1);
  }
  return m;
}

/// Chi-square statistic of values in [0, 1) against the uniform distribution, 20 equal cells.
double chi_square(const std::vector<double>& values) {
  std::array<int, 20> cells{};
  for (const double v : values) {
    ++cells[std::min<std::size_t>(cells.size() - 1,
                                  static_cast<std::size_t>(v * static_cast<double>(cells.size())))];
  }
  const double expected = static_cast<double>(values.size()) / static_cast<double>(cells.size());
  double sum = 0.0;
  for (const int count : cells) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

/// With 19 degrees of freedom, exceeded once in 10^5 times.
constexpr double kChiSquareBound = 58.0;

TEST(SimulateTest, SameKeySameScene) {
  for (const ScenarioSpec& spec : scenario_list()) {
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
  for (const ScenarioSpec& spec : scenario_list()) {
    for (const Scan& scan : simulate(spec, kSeed, 1).scans) {
      EXPECT_TRUE(std::ranges::is_sorted(scan.plots, {}, &Plot::range_km));
      for (const Plot& plot : scan.plots) EXPECT_LE(std::abs(plot.bearing_rad), pi);
    }
  }
}

/// A target's plot in a scan, if it has one; never two.
const Plot* plot_of(const Scan& scan, int target) {
  const Plot* found = nullptr;
  for (const Plot& plot : scan.plots) {
    if (plot.source != target) continue;
    EXPECT_EQ(found, nullptr) << "two plots of target " << target;
    found = &plot;
  }
  return found;
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

TEST(SimulateTest, BirthsAndFalseAlarmsArePoisson) {
  const std::map<std::string, std::pair<double, double>> table = {
      {"A", {1.0, 1.0}}, {"B", {1.0, 5.0}}, {"C", {1.0, 25.0}}, {"D", {3.0, 2.0}}};
  for (const ScenarioSpec& spec : scenario_list()) {
    SCOPED_TRACE(spec.name);
    std::vector<double> born;
    std::vector<double> false_alarms;
    for (const Scene& scene : replicates(spec, 60)) {
      std::size_t known = 0;
      for (const Scan& scan : scene.scans) {
        born.push_back(static_cast<double>(scan.truth.size() - known));  // nobody ever vanishes
        known = scan.truth.size();
        false_alarms.push_back(static_cast<double>(
            std::ranges::count(scan.plots, kFalseAlarm, [](const Plot& p) { return p.source; })));
      }
    }
    const auto expect_poisson = [](const std::vector<double>& counts, double mean) {
      const double error = std::sqrt(mean / static_cast<double>(counts.size()));
      EXPECT_NEAR(moments(counts).mean, mean, 5.0 * error);
      EXPECT_NEAR(moments(counts).variance, mean, 0.2 * mean);
    };
    expect_poisson(born, table.at(spec.name).first);
    expect_poisson(false_alarms, table.at(spec.name).second);
  }
}

TEST(SimulateTest, TargetsAppearUniformlyInTheirSquare) {
  for (const char* group : {"A", "D"}) {
    SCOPED_TRACE(group);
    const bool packed = std::string(group) == "D";
    const double side = packed ? 3.0 : 100.0;
    const double centre = packed ? 33.0 : 0.0;
    std::vector<double> x;
    std::vector<double> y;
    for (const TargetState& state : births(replicates(*find_scenario(group), 60))) {
      x.push_back((state.x - centre) / side + 0.5);
      y.push_back((state.y - centre) / side + 0.5);
    }
    for (const std::vector<double>& axis : {x, y}) {
      EXPECT_GE(*std::ranges::min_element(axis), 0.0);
      EXPECT_LE(*std::ranges::max_element(axis), 1.0);
      EXPECT_LE(chi_square(axis), kChiSquareBound);
    }
  }
}

TEST(SimulateTest, SpeedAndHeadingAreUniform) {
  for (const char* group : {"A", "D"}) {
    SCOPED_TRACE(group);
    const double fastest = std::string(group) == "D" ? 0.5 : 1.0;
    std::vector<double> speeds;
    std::vector<double> headings;
    for (const TargetState& state : births(replicates(*find_scenario(group), 60))) {
      speeds.push_back((std::hypot(state.vx, state.vy) - 0.1) / (fastest - 0.1));
      headings.push_back(std::atan2(state.vy, state.vx) / (2.0 * pi) + 0.5);
    }
    EXPECT_GE(*std::ranges::min_element(speeds), -1e-12);
    EXPECT_LE(*std::ranges::max_element(speeds), 1.0 + 1e-12);
    EXPECT_LE(chi_square(speeds), kChiSquareBound);
    EXPECT_LE(chi_square(headings), kChiSquareBound);
  }
}

/// Position and velocity after a period, less straight motion, are an acceleration's doing.
TEST(SimulateTest, TargetsMoveStraightButForTheirAccelerations) {
  const ScenarioSpec& spec = *find_scenario("D");
  std::vector<double> accelerations;
  for (const Scene& scene : replicates(spec, 5)) {
    for (std::size_t scan = 1; scan < scene.scans.size(); ++scan) {
      for (const TruePosition& before : scene.scans[scan - 1].truth) {
        const TruePosition* after = truth_of(scene.scans[scan], before.target);
        ASSERT_NE(after, nullptr);
        const double ax = (after->state.vx - before.state.vx) / 8.0;
        const double ay = (after->state.vy - before.state.vy) / 8.0;
        EXPECT_NEAR(after->state.x, before.state.x + 8.0 * before.state.vx + 32.0 * ax, 1e-9);
        EXPECT_NEAR(after->state.y, before.state.y + 8.0 * before.state.vy + 32.0 * ay, 1e-9);
        accelerations.push_back(ax);
        accelerations.push_back(ay);
      }
    }
  }
  const Moments m = moments(accelerations);
  const double n = static_cast<double>(accelerations.size());
  EXPECT_GT(n, 5000);
  EXPECT_NEAR(m.mean, 0.0, 5.0 * 5e-5 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(m.variance), 5e-5, 0.05 * 5e-5);
}

TEST(SimulateTest, TargetsInRangeAreDetectedNineTimesInTen) {
  double in_range = 0.0;
  double detected = 0.0;
  for (const Scene& scene : replicates(*find_scenario("A"), 40)) {
    for (const Scan& scan : scene.scans) {
      for (const TruePosition& position : scan.truth) {
        const bool seen = plot_of(scan, position.target) != nullptr;
        if (range_of(position.state) > 50.0) {
          EXPECT_FALSE(seen) << "seen out of range";
          continue;
        }
        in_range += 1.0;
        detected += seen ? 1.0 : 0.0;
      }
    }
  }
  // A miss rate wrong by a fifth is 0.08 or 0.12.
  ASSERT_GT(in_range, 5000.0);
  EXPECT_NEAR(detected / in_range, 0.9, 0.02);
}

TEST(SimulateTest, PlotsErrByTheSensorsNoise) {
  std::vector<double> range_errors;
  std::vector<double> bearing_errors;
  for (const Scene& scene : replicates(*find_scenario("A"), 40)) {
    for (const Scan& scan : scene.scans) {
      for (const Plot& plot : scan.plots) {
        if (plot.source == kFalseAlarm) continue;
        const TruePosition* truth = truth_of(scan, plot.source);
        ASSERT_NE(truth, nullptr);
        const double range = range_of(truth->state);
        if (range < 0.1) continue;  // a negative range is turned round
        range_errors.push_back((plot.range_km - range) / 0.015);
        bearing_errors.push_back(
            std::remainder(plot.bearing_rad - std::atan2(truth->state.y, truth->state.x),
                           2.0 * pi) /
            0.0052);
      }
    }
  }
  const double n = static_cast<double>(range_errors.size());
  ASSERT_GT(n, 5000.0);
  for (const std::vector<double>& errors : {range_errors, bearing_errors}) {
    EXPECT_NEAR(moments(errors).mean, 0.0, 5.0 / std::sqrt(n));
    EXPECT_NEAR(moments(errors).variance, 1.0, 5.0 * std::sqrt(2.0 / n));
    EXPECT_LE(std::abs(*std::ranges::max_element(errors)), 6.0);
    EXPECT_GE(*std::ranges::min_element(errors), -6.0);
  }
}

TEST(SimulateTest, FalseAlarmsAreUniformInTheArea) {
  std::vector<double> area_inside;
  std::vector<double> bearings;
  for (const Scene& scene : replicates(*find_scenario("C"), 10)) {
    for (const Scan& scan : scene.scans) {
      for (const Plot& plot : scan.plots) {
        if (plot.source != kFalseAlarm) continue;
        const double share_of_range = plot.range_km / 50.0;
        area_inside.push_back(share_of_range * share_of_range);
        bearings.push_back(plot.bearing_rad / (2.0 * pi) + 0.5);
      }
    }
  }
  ASSERT_GT(area_inside.size(), 5000u);
  EXPECT_LE(*std::ranges::max_element(area_inside), 1.0);
  EXPECT_LE(chi_square(area_inside), kChiSquareBound);
  EXPECT_LE(chi_square(bearings), kChiSquareBound);
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

TEST(DrawsTest, EveryPartOfTheKeyCounts) {
  const DrawKey key{1, "A", 1, 1, Purpose::kBirths};
  std::vector<DrawKey> others(5, key);
  others[0].seed = 2;
  others[1].scenario = "B";
  others[2].replicate = 2;
  others[3].scan = 2;
  others[4].purpose = Purpose::kMotion;
  auto engine = draws(key);
  auto again = draws(key);
  const auto first = engine();
  EXPECT_EQ(again(), first);
  for (const DrawKey& other : others) EXPECT_NE(draws(other)(), first);
}

}  // namespace
}  // namespace testing
}  // namespace mda
