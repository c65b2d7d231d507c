// What three sensors report of the same targets at one instant (Bojilov 1995, section 5).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scenarios/spec.h"

namespace mda {

inline constexpr int kSensors = 3;
inline constexpr int kNoTarget = -1;

/// Positions in mean target distances.
struct SensorReport {
  double x = 0.0;
  double y = 0.0;
  int target = kNoTarget;  ///< the truth, not for solvers
};

struct SensorScene {
  double side = 0.0;  ///< of the square, from (0, 0), in which targets and false alarms are
  std::array<std::vector<SensorReport>, kSensors> reports;  ///< in random order
};

/// One sentence about the first value of the scenario that makes no scene, naming its field, or an
/// empty text: no targets, a grid of targets that is no square, a standard deviation or detection
/// probability that is not above 0, a share of false alarms out of [0, 100], a gate not above 0.
[[nodiscard]] std::string sensor_fault(const ScenarioSpec& spec);

/// Draws are keyed by seed, scenario (or whose draws it uses), replicate and sensor. A target that
/// is missed draws its error too. Throws std::invalid_argument if the scenario has no sensors, or
/// with the sentence of sensor_fault().
[[nodiscard]] SensorScene simulate_sensors(const ScenarioSpec& spec, std::uint64_t seed,
                                           int replicate);

}  // namespace mda
