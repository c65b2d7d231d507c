// How a run of a solver library ended, the Solution that says so, and how long it took.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/api/solution.h"

namespace mda {

enum class Outcome : std::uint8_t { kOptimal, kInfeasible, kDeadline };

/// What a library has made of a whole window.
struct LibraryRun {
  Outcome outcome = Outcome::kDeadline;
  std::vector<double> x;   ///< one per column, in [0, 1]; at the deadline the incumbent or empty
  double objective = 0.0;  ///< of x, nats
  std::int64_t nodes = 0;
  std::int64_t iterations = 0;
  double translate_ms = 0.0;
};

/// The Solution without an answer of a run that ended with `outcome`.
[[nodiscard]] Solution no_answer(Outcome outcome);

[[nodiscard]] inline double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace mda
