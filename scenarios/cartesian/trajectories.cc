#include "scenarios/cartesian/trajectories.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mda {
namespace {

constexpr int kDogLeg = 8;
constexpr int kAccelerating = 9;

/// Table 1, corrected: [number - 1], at time 0.
constexpr std::array<TargetState, 10> kStart = {{
    {.x = -4.0, .vx = 0.2, .y = 1.0, .vy = -0.05},
    {.x = -4.0, .vx = 0.2, .y = -1.0, .vy = 0.05},
    {.x = -6.0, .vx = 0.0, .y = -5.0, .vy = 0.3},
    {.x = -5.5, .vx = 0.0, .y = -5.0, .vy = 0.3},
    {.x = 8.0, .vx = -0.4, .y = -7.0, .vy = 0.0},
    {.x = -8.0, .vx = 0.4, .y = -8.0, .vy = 0.0},
    {.x = -5.0, .vx = 0.25, .y = 9.0, .vy = 0.0},
    {.x = -5.0, .vx = 0.25, .y = 8.9, .vy = 0.0},
    {.x = 0.5, .vx = 0.1, .y = -3.0, .vy = 0.2},
    {.x = 9.0, .vx = 0.01, .y = -9.0, .vy = 0.2},
}};

TargetState straight_on(const TargetState& s, double seconds) {
  return {s.x + s.vx * seconds, s.vx, s.y + s.vy * seconds, s.vy};
}

/// Along a circle to the right.
TargetState turned(const TargetState& s, double acceleration_km_s2, double angle_rad) {
  const double speed = std::hypot(s.vx, s.vy);
  const double radius = speed * speed / acceleration_km_s2;
  const double c = std::cos(angle_rad);
  const double n = std::sin(angle_rad);
  const double along = radius * n;
  const double aside = radius * (1.0 - c);
  return {s.x + (along * s.vx + aside * s.vy) / speed, c * s.vx + n * s.vy,
          s.y + (along * s.vy - aside * s.vx) / speed, c * s.vy - n * s.vx};
}

TargetState dog_leg(const TargetState& start, double time_s) {
  constexpr double kBeginS = 10.0;
  constexpr double kAccelerationKmS2 = 0.02;
  constexpr double kAngleRad = std::numbers::pi / 6.0;
  if (time_s <= kBeginS) return straight_on(start, time_s);
  const double rate_rad_s = kAccelerationKmS2 / std::hypot(start.vx, start.vy);
  const double angle = std::min(rate_rad_s * (time_s - kBeginS), kAngleRad);
  const TargetState bent = turned(straight_on(start, kBeginS), kAccelerationKmS2, angle);
  return straight_on(bent, time_s - kBeginS - angle / rate_rad_s);
}

TargetState accelerating(const TargetState& start, double time_s) {
  constexpr double kBeginS = 1.0;
  constexpr double kEndS = 35.0;
  constexpr double kAccelerationKmS2 = 0.01;
  const double faster_s = std::clamp(time_s, kBeginS, kEndS) - kBeginS;
  const double later_s = std::max(0.0, time_s - kEndS);
  const double gained = kAccelerationKmS2 * faster_s / std::hypot(start.vx, start.vy);
  TargetState s = straight_on(start, time_s);
  s.x += start.vx * gained * (0.5 * faster_s + later_s);
  s.y += start.vy * gained * (0.5 * faster_s + later_s);
  s.vx += start.vx * gained;
  s.vy += start.vy * gained;
  return s;
}

}  // namespace

std::vector<int> target_numbers(PositionScene scene) {
  switch (scene) {
    case PositionScene::kCrossing:
      return {1, 2};
    case PositionScene::kParallel:
      return {3, 4};
    case PositionScene::kTen:
      break;
  }
  std::vector<int> numbers(kStart.size());
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

bool manoeuvres(int number) { return number == kDogLeg || number == kAccelerating; }

std::vector<TargetState> true_states(const PositionTargets& targets, double time_s) {
  std::vector<TargetState> states;
  for (const int number : target_numbers(targets.scene)) {
    const TargetState& start = kStart[static_cast<std::size_t>(number - 1)];
    if (number == kDogLeg) {
      states.push_back(dog_leg(start, time_s));
    } else if (number == kAccelerating) {
      states.push_back(accelerating(start, time_s));
    } else {
      states.push_back(straight_on(start, time_s));
    }
  }
  return states;
}

}  // namespace mda
