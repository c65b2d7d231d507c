// A sweep as a list of independent cells.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/sweep.h"

namespace mda {

/// One forest and all its windows: what one worker does in one go.
struct Cell {
  const ScenarioSpec* spec = nullptr;  ///< points into the Sweep; its scan period is not yet set
  double scan_period_s = 8.0;
  int replicate = 1;
  int window_k = 3;
};

/// All cells, those that are likely to take longest first, so that the workers end together. The
/// sweep must outlive them.
[[nodiscard]] std::vector<Cell> plan(const Sweep& sweep);

/// The cell's scenario with its scan period.
[[nodiscard]] ScenarioSpec scenario_of(const Cell& cell);

}  // namespace mda
