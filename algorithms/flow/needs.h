// What the flow methods need of a window, and why they decline others.
#pragma once

#include "algorithms/api/associator.h"

namespace mda {

/// Every track of the window is a fixed one, and its hypothesis tree is there.
[[nodiscard]] Verdict needs_tree_of_known_tracks(const Shape& shape);

/// Every track may be dropped, and the hypothesis tree is there.
[[nodiscard]] Verdict needs_tree_of_free_tracks(const Shape& shape);

}  // namespace mda
