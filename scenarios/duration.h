// How many scans a scenario has whose targets are on fixed trajectories.
#pragma once

#include <optional>

#include "scenarios/spec.h"

namespace mda {

/// Seconds; nothing where targets appear and vanish.
[[nodiscard]] std::optional<double> duration_s(const ScenarioSpec& spec);

/// floor(duration / scan period). Throws std::invalid_argument if there is no duration.
[[nodiscard]] int scan_count(const ScenarioSpec& spec);

}  // namespace mda
