// Table 1 of Storms & Spieksma 2003 as statistics of the scenes. The seed is fixed, so every test
// gives the same answer each time. Bounds are about five standard errors, and narrower than what a
// parameter wrong by a fifth would shift.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/groups.h"
#include "scenarios/testing/known.h"
#include "scenarios/testing/scenes.h"
#include "scenarios/world/simulate.h"

namespace mda::testing {
namespace {

using std::numbers::pi;

std::vector<Scene> replicates(const ScenarioSpec& spec, int count) {
  std::vector<Scene> scenes;
  for (int replicate = 1; replicate <= count; ++replicate) {
    scenes.push_back(simulate(spec, 1, replicate));
  }
  return scenes;
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

TEST(TableOneTest, BirthsAndFalseAlarmsArePoisson) {
  const std::map<std::string, std::pair<double, double>> table = {
      {"A", {1.0, 1.0}}, {"B", {1.0, 5.0}}, {"C", {1.0, 25.0}}, {"D", {3.0, 2.0}}};
  for (const ScenarioSpec& spec : storms_groups()) {
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

TEST(TableOneTest, TargetsAppearUniformlyInTheirSquare) {
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

TEST(TableOneTest, SpeedAndHeadingAreUniform) {
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
TEST(TableOneTest, TargetsMoveStraightButForTheirAccelerations) {
  const ScenarioSpec& spec = *find_scenario("D");
  std::vector<double> accelerations;
  double product = 0.0;  // of both axes, which are independent
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
        product += ax * ay;
      }
    }
  }
  const Moments m = moments(accelerations);
  const double n = static_cast<double>(accelerations.size());
  EXPECT_GT(n, 5000);
  EXPECT_NEAR(m.mean, 0.0, 5.0 * 5e-5 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(m.variance), 5e-5, 0.05 * 5e-5);
  EXPECT_NEAR(product / (0.5 * n), 0.0, 5.0 * 5e-5 * 5e-5 / std::sqrt(0.5 * n));
}

TEST(TableOneTest, TargetsInRangeAreDetectedNineTimesInTen) {
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

TEST(TableOneTest, PlotsErrByTheSensorsNoise) {
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

TEST(TableOneTest, FalseAlarmsAreUniformInTheArea) {
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

}  // namespace
}  // namespace mda::testing
