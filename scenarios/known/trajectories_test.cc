#include "scenarios/known/trajectories.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scenarios/groups.h"
#include "scenarios/testing/known.h"

namespace mda::testing {
namespace {

/// From `first` in steps, before `end`.
std::vector<double> times_s(double first, double step, double end) {
  std::vector<double> times;
  for (int i = 0; first + i * step < end; ++i) times.push_back(first + i * step);
  return times;
}

constexpr double kDegree = std::numbers::pi / 180.0;

double apart(const TargetState& a, const TargetState& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

double speed(const TargetState& s) { return std::hypot(s.vx, s.vy); }

double heading(const TargetState& s) { return std::atan2(s.vy, s.vx); }

const KnownTargets& targets_of(const char* scenario) {
  return *find_scenario(scenario)->known_targets;
}

TEST(TrajectoriesTest, CrossingTargetsMeetTwice) {
  for (const char* scenario : {"battistelli-2", "battistelli-2-radial"}) {
    for (const double time_s : {160.0, 270.0}) {
      const auto states = true_states(targets_of(scenario), time_s);
      ASSERT_EQ(states.size(), 3U);
      EXPECT_NEAR(apart(states[0], states[1]), 0.0, 1e-9);
      EXPECT_NEAR(apart(states[2], states[1]), 0.0, 1e-9);
    }
    for (const double time_s : {100.0, 200.0, 225.0, 350.0}) {
      const auto states = true_states(targets_of(scenario), time_s);
      EXPECT_GT(apart(states[0], states[2]), 1.0);
    }
  }
}

TEST(TrajectoriesTest, CrossingTargetsFlyAsStated) {
  const KnownTargets& targets = targets_of("battistelli-2");
  const double axis = targets.axis_heading_rad;
  const auto before = true_states(targets, 50.0);
  const auto after = true_states(targets, 300.0);
  EXPECT_NEAR(heading(before[0]) - axis, 20.0 * kDegree, 1e-12);
  EXPECT_NEAR(heading(before[1]) - axis, 0.0, 1e-12);
  EXPECT_NEAR(heading(before[2]) - axis, -20.0 * kDegree, 1e-12);
  EXPECT_NEAR((axis - heading(after[0])) / kDegree, 29.25, 0.005);
  EXPECT_NEAR(heading(after[1]) - axis, 0.0, 1e-12);
  EXPECT_NEAR((heading(after[2]) - axis) / kDegree, 29.25, 0.005);
  EXPECT_NEAR(speed(before[1]), 0.09430, 5e-6);
  EXPECT_NEAR(speed(before[0]), 0.1, 1e-12);
}

TEST(TrajectoriesTest, VelocityIsTheChangeOfPosition) {
  constexpr double kStepSeconds = 1e-3;
  for (const ScenarioSpec& spec : known_scenarios()) {
    SCOPED_TRACE(spec.name);
    for (const double time_s : times_s(0.5, 3.7, spec.known_targets->duration_s)) {
      const auto now = true_states(*spec.known_targets, time_s);
      const auto before = true_states(*spec.known_targets, time_s - kStepSeconds);
      const auto after = true_states(*spec.known_targets, time_s + kStepSeconds);
      for (std::size_t i = 0; i < now.size(); ++i) {
        EXPECT_NEAR((after[i].x - before[i].x) / (2.0 * kStepSeconds), now[i].vx, 1e-6);
        EXPECT_NEAR((after[i].y - before[i].y) / (2.0 * kStepSeconds), now[i].vy, 1e-6);
        EXPECT_NEAR(speed(after[i]), speed(before[i]), 1e-12);
        const double acceleration = std::hypot(after[i].vx - before[i].vx,  //
                                               after[i].vy - before[i].vy) /
                                    (2.0 * kStepSeconds);
        EXPECT_LT(acceleration, 1.73e-3);
      }
    }
  }
}

TEST(TrajectoriesTest, PlatoonsKeepTheirFormation) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    const KnownTargets& targets = *spec.known_targets;
    if (targets.trajectories != Trajectories::kPlatoons) continue;
    const auto middle = true_states(targets, 150.0);
    ASSERT_EQ(middle.size(), 20U);
    for (const std::size_t first : {0U, 10U}) {
      double x = 0.0;
      double y = 0.0;
      for (std::size_t i = first; i < first + 10; ++i) {
        x += middle[i].x / 10.0;
        y += middle[i].y / 10.0;
        EXPECT_NEAR(heading(middle[i]), (first == 0 ? 45.0 : 135.0) * kDegree, 1e-12);
        EXPECT_NEAR(speed(middle[i]), 0.03, 1e-12);
        if (i == first) continue;
        const double expected = targets.lateral_spacing_km * std::hypot(1.0, 0.7);
        EXPECT_NEAR(apart(middle[i], middle[i - 1]), expected, 1e-12);
        for (const double time_s : {0.0, 300.0}) {
          const auto then = true_states(targets, time_s);
          EXPECT_NEAR(apart(then[i], then[i - 1]), expected, 1e-12);
        }
      }
      EXPECT_NEAR(x, 0.0, 1e-12);
      EXPECT_NEAR(y, 20.0, 1e-12);
    }
  }
}

TEST(TrajectoriesTest, TheClutterBoxHoldsAllTrajectoriesWithAMargin) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    SCOPED_TRACE(spec.name);
    const PlotBox box = clutter_box(*spec.known_targets);
    const double range_margin = 0.08 * (box.range_high_km - box.range_low_km);
    const double bearing_margin = 0.08 * (box.bearing_high_rad - box.bearing_low_rad);
    double nearest = box.range_high_km;
    for (const double time_s : times_s(0.0, 0.37, spec.known_targets->duration_s)) {
      for (const TargetState& state : true_states(*spec.known_targets, time_s)) {
        const double range = std::hypot(state.x, state.y);
        const double bearing = std::atan2(state.y, state.x);
        const double rate = (state.x * state.vx + state.y * state.vy) / range;
        EXPECT_GT(range, box.range_low_km + range_margin);
        EXPECT_LT(range, box.range_high_km - range_margin);
        EXPECT_GT(bearing, box.bearing_low_rad + bearing_margin);
        EXPECT_LT(bearing, box.bearing_high_rad - bearing_margin);
        EXPECT_GT(rate, box.range_rate_low_km_s);
        EXPECT_LT(rate, box.range_rate_high_km_s);
        nearest = std::min(nearest, range);
      }
    }
    EXPECT_NEAR(nearest - box.range_low_km, (box.range_high_km - box.range_low_km) / 12.0, 0.05);
  }
}

}  // namespace
}  // namespace mda::testing
