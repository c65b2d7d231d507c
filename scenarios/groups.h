// The one list of scenarios.
#pragma once

#include <span>
#include <string_view>

#include "scenarios/spec.h"

namespace mda {

/// Groups A-D of Storms & Spieksma 2003, Table 1, then the scenes of known targets of Battistelli
/// et al. 2008, section IV: scenario 1 with three spacings, scenario 2 along two axes and with
/// three more resolutions.
[[nodiscard]] std::span<const ScenarioSpec> scenario_list();

/// nullptr when there is no scenario of that name.
[[nodiscard]] const ScenarioSpec* find_scenario(std::string_view name);

}  // namespace mda
