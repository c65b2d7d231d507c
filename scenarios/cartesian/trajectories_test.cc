#include "scenarios/cartesian/trajectories.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mda::testing {
namespace {

constexpr std::size_t kEight = 7;
constexpr std::size_t kNine = 8;

std::vector<TargetState> ten_at(double time_s) {
  return true_states({.scene = PositionScene::kTen}, time_s);
}

double distance_km(const TargetState& a, const TargetState& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

double speed_km_s(const TargetState& s) { return std::hypot(s.vx, s.vy); }

TEST(LeeTrajectoriesTest, ScenesAreParts) {
  EXPECT_EQ(target_numbers(PositionScene::kCrossing), (std::vector<int>{1, 2}));
  EXPECT_EQ(target_numbers(PositionScene::kParallel), (std::vector<int>{3, 4}));
  for (const double time_s : {-1.0, 0.0, 7.0, 40.0}) {
    const auto all = ten_at(time_s);
    ASSERT_EQ(all.size(), 10U);
    const auto crossing = true_states({.scene = PositionScene::kCrossing}, time_s);
    const auto parallel = true_states({.scene = PositionScene::kParallel}, time_s);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(distance_km(crossing[i], all[i]), 0.0);
      EXPECT_EQ(distance_km(parallel[i], all[i + 2]), 0.0);
    }
  }
}

TEST(LeeTrajectoriesTest, OneAndTwoMeetHalfWayInTheOrigin) {
  const TargetState origin{};
  for (int k = 0; k <= 40; ++k) {
    const auto states = ten_at(k);
    EXPECT_NEAR(states[0].y, -states[1].y, 1e-12);
    EXPECT_NEAR(distance_km(states[0], states[1]), 0.1 * std::abs(k - 20), 1e-12);
  }
  EXPECT_NEAR(distance_km(ten_at(20.0)[0], origin), 0.0, 1e-12);
  EXPECT_NEAR(distance_km(ten_at(20.0)[1], origin), 0.0, 1e-12);
}

TEST(LeeTrajectoriesTest, ThreeAndFourStayHalfAKilometreApart) {
  for (int k = 0; k <= 40; ++k) {
    EXPECT_NEAR(distance_km(ten_at(k)[2], ten_at(k)[3]), 0.5, 1e-12);
  }
}

TEST(LeeTrajectoriesTest, FiveAndSixCrossTheWholeArea) {
  EXPECT_NEAR(ten_at(40.0)[4].x, -8.0, 1e-12);
  EXPECT_NEAR(ten_at(40.0)[5].x, 8.0, 1e-12);
}

TEST(LeeTrajectoriesTest, EightLeavesSevenByThirtyDegrees) {
  for (const double time_s : {0.0, 5.0, 10.0}) {
    EXPECT_NEAR(distance_km(ten_at(time_s)[kEight - 1], ten_at(time_s)[kEight]), 0.1, 1e-12);
  }
  double apart = 0.1;
  for (int half_s = 21; half_s <= 80; ++half_s) {
    const double time_s = 0.5 * half_s;
    const double now = distance_km(ten_at(time_s)[kEight - 1], ten_at(time_s)[kEight]);
    EXPECT_GT(now, apart);
    apart = now;
  }
  const TargetState end = ten_at(17.0)[kEight];
  EXPECT_NEAR(std::atan2(end.vy, end.vx), -std::numbers::pi / 6.0, 1e-12);
  EXPECT_NEAR(ten_at(40.0)[kEight].vx, end.vx, 1e-12) << "straight on";
  EXPECT_LT(ten_at(16.4)[kEight].vx, ten_at(10.1)[kEight].vx) << "it takes 6.5 s";
  EXPECT_GT(ten_at(16.4)[kEight].vx, end.vx);
}

TEST(LeeTrajectoriesTest, NineGainsSpeedAlongItsHeading) {
  for (int k = 0; k <= 40; ++k) {
    const TargetState s = ten_at(k)[kNine];
    EXPECT_NEAR(std::atan2(s.vy, s.vx), std::atan2(0.2, 0.1), 1e-12);
    const double gain = 0.01 * (std::min(std::max(k, 1), 35) - 1);
    EXPECT_NEAR(speed_km_s(s), std::hypot(0.1, 0.2) + gain, 1e-12);
  }
}

/// Positions are what the velocities add up to, and no acceleration is beyond Table 2's.
TEST(LeeTrajectoriesTest, VelocityIsTheDerivativeOfPosition) {
  constexpr double kStepSeconds = 1e-3;
  for (int quarter_s = -4; quarter_s < 160; ++quarter_s) {
    const double time_s = 0.25 * quarter_s;
    const auto before = ten_at(time_s);
    const auto after = ten_at(time_s + kStepSeconds);
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_NEAR((after[i].x - before[i].x) / kStepSeconds, before[i].vx, 2e-5);
      EXPECT_NEAR((after[i].y - before[i].y) / kStepSeconds, before[i].vy, 2e-5);
      const double acceleration =
          std::hypot(after[i].vx - before[i].vx, after[i].vy - before[i].vy) / kStepSeconds;
      const double most = i == kEight ? 0.02 : i == kNine ? 0.01 : 0.0;
      EXPECT_LE(acceleration, most + 1e-9) << i + 1 << " at " << time_s;
      EXPECT_EQ(manoeuvres(static_cast<int>(i) + 1), most > 0.0);
    }
  }
}

}  // namespace
}  // namespace mda::testing
