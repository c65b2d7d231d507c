// The hypotheses behind a window's columns as the view that the flow methods work on.
#pragma once

#include "algorithms/api/views.h"
#include "scenarios/hypotheses/extract.h"
#include "scenarios/hypotheses/track_forest.h"

namespace mda {

/// The part of the forest that leads to columns of `window`, which was extracted from it. The
/// forest must keep its costs. O(nodes of the window's scans).
[[nodiscard]] HypothesisTree tree_of(const TrackForest& forest, const WindowInstance& window);

}  // namespace mda
