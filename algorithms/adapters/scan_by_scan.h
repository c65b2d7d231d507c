// Decides a window scan after scan with an algorithm that knows a single scan only.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Walks through the problem's HypothesisTree: in every scan the live partial tracks and the plots
/// make a two-dimensional problem, which `inner` solves, and the chosen children live on. Decisions
/// are never taken back, but for dropping a track.
///
/// A pair costs the step to the plot's child, less what the track does otherwise (the step to its
/// child without a plot, or being dropped), less what the plot does otherwise (its cheapest column
/// alone, or nothing). Every plot left free starts a tentative track where the tree has one. In the
/// end a track is dropped if its rows are cheaper without it.
///
/// Every row of the inner problems is used at most once. An answer of `inner` that is no selection
/// is an error (std::logic_error). O(K) inner solves of at most as many columns as the tree has
/// nodes in a layer.
[[nodiscard]] std::unique_ptr<Associator> make_scan_by_scan(std::unique_ptr<Associator> inner);

}  // namespace mda
