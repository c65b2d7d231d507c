#include "scenarios/groups.h"

#include <array>

namespace mda {
namespace {

ScenarioSpec wide_group(std::string name, double clutter_per_scan, std::string summary) {
  ScenarioSpec spec{std::move(name), std::move(summary), {}, {}};
  spec.world.clutter_per_scan = clutter_per_scan;
  return spec;
}

/// The paper does not say where the small square lies: at (33, 33) km the LP is about as often
/// fractional as published.
ScenarioSpec packed_group() {
  ScenarioSpec spec{"D", "slow targets from a square of 3 km side, closely spaced", {}, {}};
  spec.world.speed_max_km_s = 0.5;
  spec.world.birth_centre_x_km = 33.0;
  spec.world.birth_centre_y_km = 33.0;
  spec.world.birth_side_km = 3.0;
  spec.world.births_per_scan = 3.0;
  spec.world.clutter_per_scan = 2.0;
  return spec;
}

}  // namespace

std::span<const ScenarioSpec> scenario_list() {
  static const std::array<ScenarioSpec, 4> kScenarios = {
      wide_group("A", 1.0, "targets all over the coverage, 1 false alarm per scan"),
      wide_group("B", 5.0, "targets all over the coverage, 5 false alarms per scan"),
      wide_group("C", 25.0, "targets all over the coverage, 25 false alarms per scan"),
      packed_group(),
  };
  return kScenarios;
}

const ScenarioSpec* find_scenario(std::string_view name) {
  for (const ScenarioSpec& spec : scenario_list()) {
    if (spec.name == name) return &spec;
  }
  return nullptr;
}

}  // namespace mda
