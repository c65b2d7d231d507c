// Scenarios of targets seen as positions, played by the truth.
#pragma once

#include <functional>
#include <vector>

#include "scenarios/cartesian/position_windows.h"
#include "scenarios/spec.h"

namespace mda::testing {

/// Those of scenario_list() that have position targets.
[[nodiscard]] std::vector<ScenarioSpec> position_scenarios();

/// Plays a replicate under seed 1: calls see(windows) for every window, then advances by the truth.
void play_true_positions(const ScenarioSpec& spec, int replicate,
                         const std::function<void(const PositionWindows&)>& see);

}  // namespace mda::testing
