// How far tracks of known targets stray: equations (IV.2) and (IV.3) of Battistelli et al. 2008,
// and the share of right plots.
#pragma once

#include <vector>

#include "scenarios/world/scene.h"

namespace mda {

/// States of all tracks, scan by scan.
using TrackStates = std::vector<std::vector<TargetState>>;

/// Mean over the tracks of the distance between their positions, km. The same sizes on both sides.
[[nodiscard]] double mean_distance_km(const std::vector<TargetState>& a,
                                      const std::vector<TargetState>& b);

/// The same for every scan.
[[nodiscard]] std::vector<double> mean_distances_km(const TrackStates& a, const TrackStates& b);

[[nodiscard]] double mean(const std::vector<double>& values);

struct LostShares {
  double ever = 0.0;    ///< share of the tracks that are too far off in any scan
  double at_end = 0.0;  ///< and in the last one
};

/// Tracks of `states` more than `lost_km` away from those of `reference`. Needs one scan at least.
[[nodiscard]] LostShares lost_shares(const TrackStates& states, const TrackStates& reference,
                                     double lost_km);

}  // namespace mda
