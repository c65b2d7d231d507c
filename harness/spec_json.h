// Scenarios in manifests: every parameter by its name, written and read by the same list of fields.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/spec.h"

namespace mda {

/// World and model of a scenario as one flat object; "known_targets", "position_targets" (with the
/// model's update) and "three_sensors", objects inside it, and "draws_as" only where the scenario
/// has such.
[[nodiscard]] nlohmann::ordered_json json_of(const ScenarioSpec& spec);

/// Reads back what json_of() wrote. Throws InputError that begins with `where` and names the field
/// that is absent or wrong.
[[nodiscard]] ScenarioSpec spec_of(const std::string& name, const nlohmann::ordered_json& json,
                                   const std::string& where);

}  // namespace mda
