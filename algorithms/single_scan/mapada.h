// MAPADA, the association of Lee and Jeong by a relaxation of the assignment in one scan.
#pragma once

#include <cstdint>
#include <memory>

#include "algorithms/api/associator.h"
#include "algorithms/single_scan/mapada_relaxation.h"

namespace mda {

/// c_jt, and with it the unit of alpha.
enum class MapadaDistance : std::uint8_t {
  kVelocityLine,  ///< the paper's (3), km^2: blind along the track
  kMahalanobis,   ///< of the innovation, chi-square
  kColumnCost     ///< nats above those of the track without a plot; outside the gate 0
};

enum class MapadaDecision : std::uint8_t {
  kAssignment,  ///< optimal on -omega: a selection
  kArgmax,      ///< every target's largest omega, so that two may take one plot
  kWeighted     ///< beta_jt = omega_jt in the gate, and no plot for what is left to 1
};

struct MapadaOptions {
  MapadaDistance distance = MapadaDistance::kVelocityLine;
  MapadaDecision decision = MapadaDecision::kAssignment;
  MapadaIteration iteration = {};
};

/// Associates one scan of fixed tracks with its plots, cluster by cluster (tracks joined by plots
/// in both their gates). Within a cluster pairs outside the gates exist too, as in the paper, at
/// their distance and a price of alpha. The paper has no missed detections; where a cluster has no
/// more plots than targets, dummy plots (distance 0, in no gate) are added until it has one more,
/// and a target that takes a dummy, or a plot outside its gate, has got none.
///
/// A selection, or by the other decisions marginals: with kArgmax they are whole, and claim a plot
/// twice at times. Takes problems with a pairs view whose plots have no columns of their own. It
/// neither bounds nor proves anything. O(iterations * tracks * plots) and an assignment per
/// cluster; Stats::iterations counts those of all clusters.
///
/// Source: Lee and Jeong, "Adaptive data association for multi-target tracking using relaxation"
/// (1998), sections II and III; the clipping, the dummies and the assignment are ours.
[[nodiscard]] std::unique_ptr<Associator> make_mapada(const MapadaOptions& options);

/// With the default options.
[[nodiscard]] std::unique_ptr<Associator> make_mapada();

}  // namespace mda
