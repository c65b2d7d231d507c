// How a run of a solver library ended, the Solution that says so, and how long it took.
#pragma once

#include <chrono>
#include <cstdint>

#include "algorithms/api/associator.h"
#include "algorithms/api/solution.h"

namespace mda {

enum class Outcome : std::uint8_t { kOptimal, kInfeasible, kDeadline };

/// The Solution without an answer of a run that ended with `outcome`.
[[nodiscard]] Solution no_answer(Outcome outcome);

[[nodiscard]] inline double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace mda
