// How well tracks of position targets keep to them (Lee & Jeong 1998, Tables 3 and 4), track n
// being that of target n.
#pragma once

#include <array>
#include <vector>

#include "scenarios/world/scene.h"

namespace mda {

/// A track is maintained if its error stays below the first in the last kLastScans scans; that is
/// three sigma of a plot. The second is more than the distance of the parallel targets: tracks that
/// have changed places count as kept. The paper has neither.
inline constexpr double kStrictLossKm = 0.45;
inline constexpr double kWideLossKm = 0.75;
inline constexpr int kLastScans = 5;

/// One track over all scans.
struct TrackErrors {
  std::vector<double> position_km;  ///< [scan - 1], after the scan
  std::vector<double> velocity_km_s;
  std::vector<double> predicted_position_km;  ///< before it
  std::vector<double> predicted_velocity_km_s;
};

/// States of one track or target, scan by scan.
using StateSeries = std::vector<TargetState>;

/// The same sizes throughout.
[[nodiscard]] TrackErrors track_errors(const StateSeries& filtered, const StateSeries& predicted,
                                       const StateSeries& truth);

[[nodiscard]] double sum_of_squares(const std::vector<double>& values);

/// Whether an error series stays below `loss_km` in its last kLastScans scans.
[[nodiscard]] bool is_maintained(const std::vector<double>& position_km, double loss_km);

/// [target][scan - 1].
struct TrackSet {
  std::vector<StateSeries> tracks;
  std::vector<StateSeries> targets;
  std::vector<bool> dropped;  ///< [target]; takes no part in what follows
};

/// Pairs of tracks that have changed places: each is, on average over the last kLastScans scans,
/// nearer to the other's target than to its own, and within kStrictLossKm of it in all of them.
[[nodiscard]] int swaps(const TrackSet& set);

/// Pairs of tracks that have become one: in all of the last kLastScans scans the two are within
/// `sigma_km` of each other, and their targets are not.
[[nodiscard]] int coalescences(const TrackSet& set, double sigma_km);

}  // namespace mda
