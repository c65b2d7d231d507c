#include "scenarios/duration.h"

#include <cmath>
#include <stdexcept>

namespace mda {

std::optional<double> duration_s(const ScenarioSpec& spec) {
  if (spec.known_targets) return spec.known_targets->duration_s;
  if (spec.position_targets) return spec.position_targets->duration_s;
  return std::nullopt;
}

int scan_count(const ScenarioSpec& spec) {
  // A quotient that is whole but for its rounding counts as whole.
  constexpr double kRounding = 1e-9;
  const std::optional<double> seconds = duration_s(spec);
  if (!seconds) throw std::invalid_argument(spec.name + " has no trajectories that are given");
  return static_cast<int>(std::floor(*seconds / spec.world.scan_period_s + kRounding));
}

}  // namespace mda
