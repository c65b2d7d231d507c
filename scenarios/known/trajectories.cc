#include "scenarios/known/trajectories.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "scenarios/known/doppler_ekf.h"

namespace mda {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kForever = 1e9;

/// Flown at constant speed and turn rate.
struct Leg {
  double until_s = kForever;
  double turn_rad_s = 0.0;
};

/// A place at some time of the first leg, and what follows.
struct Route {
  double time_s = 0.0;
  double x = 0.0;
  double y = 0.0;
  double heading_rad = 0.0;
  double speed_km_s = 0.0;
};

/// Along a circle, or straight, for a time of either sign.
void fly(Route& at, double turn_rad_s, double seconds) {
  const double before = at.heading_rad;
  const double after = before + turn_rad_s * seconds;
  if (turn_rad_s == 0.0) {
    at.x += at.speed_km_s * seconds * std::cos(before);
    at.y += at.speed_km_s * seconds * std::sin(before);
  } else {
    const double radius_km = at.speed_km_s / turn_rad_s;
    at.x += radius_km * (std::sin(after) - std::sin(before));
    at.y -= radius_km * (std::cos(after) - std::cos(before));
  }
  at.heading_rad = after;
  at.time_s += seconds;
}

TargetState state_at(Route at, std::span<const Leg> legs, double time_s) {
  for (const Leg& leg : legs) {
    fly(at, leg.turn_rad_s, std::min(leg.until_s, time_s) - at.time_s);
    if (time_s <= leg.until_s) break;
  }
  return {at.x, at.speed_km_s * std::cos(at.heading_rad), at.y,
          at.speed_km_s * std::sin(at.heading_rad)};
}

void add_platoon(const KnownTargets& targets, double heading_rad, double time_s,
                 std::vector<TargetState>& states) {
  constexpr int kSize = 10;
  constexpr double kStagger = 0.35;
  const double along_x = std::cos(heading_rad);
  const double along_y = std::sin(heading_rad);
  for (int i = 0; i < kSize; ++i) {
    const double aside = (i - 0.5 * (kSize - 1)) * targets.lateral_spacing_km;
    const double ahead = (i % 2 == 1 ? kStagger : -kStagger) * targets.lateral_spacing_km;
    const Route route{150.0, ahead * along_x - aside * along_y,
                      20.0 + ahead * along_y + aside * along_x, heading_rad, 0.03};
    const Leg straight;
    states.push_back(state_at(route, {&straight, 1}, time_s));
  }
}

// The crossing, in its own frame: the first meeting is the origin, the axis is x.
constexpr double kFirstMeeting_s = 160.0;
constexpr double kSecondMeeting_s = 270.0;
constexpr double kTurnBegin_s = 200.0;
constexpr double kTurnEnd_s = 250.0;
constexpr double kOuterSpeed_km_s = 0.1;
constexpr double kOuterHeading_rad = 20.0 * kDegree;

/// A, or with `side` -1 its mirror image C; `beta_rad`: its angle to the axis after the turn.
TargetState outer_at(double side, double beta_rad, double time_s) {
  const double turn = -(kOuterHeading_rad + beta_rad) / (kTurnEnd_s - kTurnBegin_s);
  const std::array<Leg, 3> legs = {{{kTurnBegin_s, 0.0}, {kTurnEnd_s, side * turn}, {}}};
  return state_at({kFirstMeeting_s, 0.0, 0.0, side * kOuterHeading_rad, kOuterSpeed_km_s}, legs,
                  time_s);
}

TargetState middle_at(double speed_km_s, double time_s) {
  const std::array<Leg, 5> legs = {
      {{kTurnBegin_s, 0.0}, {212.5, kDegree}, {237.5, -kDegree}, {kTurnEnd_s, kDegree}, {}}};
  return state_at({kFirstMeeting_s, 0.0, 0.0, 0.0, speed_km_s}, legs, time_s);
}

struct Meeting {
  double beta_rad = 0.0;
  double middle_speed_km_s = 0.0;
};

/// A is back on the axis at the second meeting for one beta up to 90 degrees: found by bisection.
/// B's way along the axis is proportional to its speed.
Meeting solve_meeting() {
  double low = 0.0;
  double high = 0.5 * std::numbers::pi;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (outer_at(1.0, middle, kSecondMeeting_s).y > 0.0 ? low : high) = middle;
  }
  return {low, outer_at(1.0, low, kSecondMeeting_s).x / middle_at(1.0, kSecondMeeting_s).x};
}

TargetState turned(const TargetState& s, double angle_rad) {
  const double c = std::cos(angle_rad);
  const double n = std::sin(angle_rad);
  return {c * s.x - n * s.y, c * s.vx - n * s.vy, n * s.x + c * s.y, n * s.vx + c * s.vy};
}

std::vector<TargetState> crossing_states(double axis_heading_rad, double time_s) {
  static const Meeting kMeeting = solve_meeting();
  std::vector<TargetState> states = {outer_at(1.0, kMeeting.beta_rad, time_s),
                                     middle_at(kMeeting.middle_speed_km_s, time_s),
                                     outer_at(-1.0, kMeeting.beta_rad, time_s)};
  for (TargetState& state : states) {
    state = turned(state, axis_heading_rad);
    state.y += 25.0;
  }
  return states;
}

/// Widens both ends by a tenth of what is between them.
void widen(double& low, double& high) {
  const double margin = 0.1 * (high - low);
  low -= margin;
  high += margin;
}

}  // namespace

std::vector<TargetState> true_states(const KnownTargets& targets, double time_s) {
  if (targets.trajectories == Trajectories::kCrossing) {
    return crossing_states(targets.axis_heading_rad, time_s);
  }
  std::vector<TargetState> states;
  add_platoon(targets, 45.0 * kDegree, time_s, states);
  add_platoon(targets, 135.0 * kDegree, time_s, states);
  return states;
}

double PlotBox::volume() const noexcept {
  return (range_high_km - range_low_km) * (bearing_high_rad - bearing_low_rad) *
         (range_rate_high_km_s - range_rate_low_km_s);
}

PlotBox clutter_box(const KnownTargets& targets) {
  Eigen::Array3d low = Eigen::Array3d::Constant(kForever);
  Eigen::Array3d high = -low;
  for (double time_s = 0.0; time_s <= targets.duration_s; time_s += 1.0) {
    for (const TargetState& state : true_states(targets, time_s)) {
      const DopplerMeasurement plot = measured(state);
      low = low.min(plot.array());
      high = high.max(plot.array());
    }
  }
  PlotBox box{low(0), high(0), low(1), high(1), low(2), high(2)};
  widen(box.range_low_km, box.range_high_km);
  widen(box.bearing_low_rad, box.bearing_high_rad);
  widen(box.range_rate_low_km_s, box.range_rate_high_km_s);
  return box;
}

}  // namespace mda
