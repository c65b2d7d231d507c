// Targets that appear, move in straight lines and are seen now and then (Storms & Spieksma 2003,
// section 4).
#pragma once

#include <cstdint>

#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

/// The scene of one replicate (counted from 1). Depends on (seed, scenario name, replicate) and the
/// world, never on the tracker's model. Under another scan period the targets appear in the same
/// scans with the same velocities, and are detected in the same scans wherever they are in range.
/// O(scans x targets).
[[nodiscard]] Scene simulate(const ScenarioSpec& spec, std::uint64_t seed, int replicate);

}  // namespace mda
