// MAPADA with missed detections.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// The relaxation of Lee and Jeong with one private measurement more per target, which stands for
/// no detection, on the columns' own costs; without clipping, and decided by optimal assignment.
/// Then the answer is that of `gnn` (assign_by_omega()), up to 12 rows kMapadaMissTolerance times
/// the largest gain, the gain of a pair being what it saves against its rows alone. No alpha is
/// better than another; it takes the one that settles fastest, sqrt(2 (m + n + 1)) largest gains.
///
/// Takes always feasible problems with at most two dimensions, with or without tracks: rows of the
/// lower dimension are the targets. Neither order nor unit of cost matters. It claims no optimum
/// and bounds nothing. O(iterations * columns) and an assignment per component.
///
/// Source: Lee and Jeong, "Adaptive data association for multi-target tracking using relaxation"
/// (1998), section III; the private measurements are ours.
[[nodiscard]] std::unique_ptr<Associator> make_mapada_miss();

/// Of the relaxation, in units of the largest gain.
inline constexpr double kMapadaMissTolerance = 1e-6;

}  // namespace mda
