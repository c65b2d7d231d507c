// Where the targets of Battistelli et al. 2008, section IV, are. The paper shows its trajectories
// in figures only; these have the properties that its text states.
//
// Platoons (scenario 1): twenty targets at 30 m/s, ten heading 45 degrees from the x axis and ten
// heading 135, both platoons centred on (0, 20) km at 150 s. Neighbours are lateral_spacing_km
// apart across the heading, and alternately 0.35 of it ahead and behind.
//
// Crossing (scenario 2): along an axis through (0, 25) km, where all three meet at 160 s. A and C
// fly 100 m/s at +20 and -20 degrees to the axis, turn evenly between 200 and 250 s to -beta and
// +beta, and stay so. B flies along the axis at v_B and swerves by +1, -1, +1 degree/s in
// 200-212.5, 212.5-237.5 and 237.5-250 s. beta = 29.25 degrees and v_B = 94.30 m/s follow from all
// three meeting again on the axis at 270 s.
#pragma once

#include <vector>

#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

/// True states of all targets at `time_s` >= 0, in the order of their numbers: first the platoon
/// that heads 45 degrees, or A, B, C. Exact (straight lines and circles). O(targets).
[[nodiscard]] std::vector<TargetState> true_states(const KnownTargets& targets, double time_s);

/// A box in what the radar measures.
struct PlotBox {
  double range_low_km = 0.0;
  double range_high_km = 0.0;
  double bearing_low_rad = 0.0;
  double bearing_high_rad = 0.0;
  double range_rate_low_km_s = 0.0;
  double range_rate_high_km_s = 0.0;

  /// km rad km/s.
  [[nodiscard]] double volume() const noexcept;
};

/// Where clutter falls: the bounding box of all trajectories, sampled every second, whatever the
/// scan period is, and widened on every side by a tenth of its extent. The trajectories stay off
/// the negative x axis, where bearings jump.
[[nodiscard]] PlotBox clutter_box(const KnownTargets& targets);

}  // namespace mda
