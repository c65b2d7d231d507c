// Look-ups in a scene.
#pragma once

#include "scenarios/world/scene.h"

namespace mda::testing {

[[nodiscard]] double range_of(const TargetState& state);

/// Where a target is in a scan, nullptr if it does not live.
[[nodiscard]] const TruePosition* truth_of(const Scan& scan, int target);

/// A target's first plot in a scan, nullptr if it has none.
[[nodiscard]] const Plot* plot_of(const Scan& scan, int target);

}  // namespace mda::testing
