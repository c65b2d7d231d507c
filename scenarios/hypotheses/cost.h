// The only place where a likelihood becomes nats: equations (6) and (8) of Storms & Spieksma 2003,
// factor by factor. The cost of a track is the sum of one term per scan since its first plot.
#pragma once

#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

struct CostTerms {
  double birth = 0.0;  ///< of a first plot: -ln(lambda_nu f_nu / (lambda_phi f_phi)), f_nu = f_phi
  /// Of a later plot, without its data: -ln(P_d / lambda_phi) + ln(2 pi). To it come
  /// ln(sqrt|B|) + d^2 / 2 of the innovation and ln f_phi of the plot.
  double detection = 0.0;
  double miss = 0.0;  ///< -ln(1 - P_d)
  /// What an ended track is charged less than a miss for each of its p + 1 last scans.
  double ended_discount = 0.0;
  /// What a live track is charged less for each miss since its last plot.
  double live_discount = 0.0;
};

/// Needs a positive clutter rate and a detection probability in (0, 1).
[[nodiscard]] CostTerms cost_terms(const World& world, const TrackerModel& model);

/// ln f_phi at a plot, in the units that model.density says.
[[nodiscard]] double log_clutter_density(const World& world, const TrackerModel& model,
                                         const Plot& plot);

}  // namespace mda
