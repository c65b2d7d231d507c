// HNPDA, the Hopfield network of Sengupta and Iltis for probabilistic data association.
#pragma once

#include <cstdint>
#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Constants of the energy, as usually quoted for the paper; none is negative.
struct HnpdaOptions {
  double a = 50.0;    ///< against two tracks with one plot
  double b = 50.0;    ///< against two plots for one track
  double c = 100.0;   ///< for a sum of 1 over the plots of a track, and none
  double d = 1000.0;  ///< for the track's own probabilities
  double e = 1000.0;  ///< for what the other tracks' probabilities leave
  double decay = 1.0;
  double gain_width = 0.02;        ///< u0
  double step = 0.3;               ///< dt as a share of the largest step that is sure to settle
  double tolerance = 1e-6;         ///< it ends when no output changes by more
  std::int64_t iterations = 5000;  ///< at most
  /// Outputs divided by their sum over the track's plots and none. If not, they are taken as they
  /// are, and none gets what they leave; only where the plots' add up to more than 1 they are
  /// divided by that.
  bool normalised = true;
};

/// One neuron V_tj for every track t and every plot j in its gate, and for no plot, j = 0. With
/// rho_tj the probabilities that a track has by itself (`pda`) and n tracks in the cluster,
///     du_tj/dt = -decay u_tj - A sum_{s != t} V_sj - B sum_{l != j} V_tl - C sum_l V_tl
///                - (D + E (n - 1)) V_tj + C + D rho_tj + E sum_{s != t} (1 - rho_sj),
///     V = (1 + tanh(u / u0)) / 2,
/// in steps dt <= step 2 u0 / (D + E (n - 1) + A n + (B + C) (m + 1)), m plots; without A for j =
/// 0, as any number of tracks may get none. The limit is unique and does not depend on u0, but for
/// the decay. It does not approach the marginals of `jpda`: E pulls the output of a plot that
/// nobody else wants towards 1. Not consistent. Every answer is made of finite numbers, settled or
/// not. O(iterations * pairs) per cluster.
///
/// Source: Sengupta and Iltis, "Neural solution to the multitarget tracking data association
/// problem", IEEE Transactions on Aerospace and Electronic Systems 25 (1989), as quoted elsewhere;
/// the mask of the gates, the step and the normalisation are ours.
[[nodiscard]] std::unique_ptr<Associator> make_hnpda(const HnpdaOptions& options);

}  // namespace mda
