// A sweep as a list of independent cells.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/sweep.h"

namespace mda {

/// One scene and all its windows: what one worker does in one go.
struct Cell {
  const ScenarioPlan* plan = nullptr;  ///< of the Sweep; the spec's scan period is not yet set
  double scan_period_s = 8.0;
  int replicate = 1;
  int window_k = 3;
};

/// All cells, those that are likely to take longest first, so that the workers end together. The
/// sweep must outlive them.
[[nodiscard]] std::vector<Cell> plan(const Sweep& sweep);

/// Whether the window of this scan is for the algorithms, not only for the driver to pass.
[[nodiscard]] inline bool is_asked(const Cell& cell, int scan) {
  return scan % cell.plan->every == 0;
}

/// The cell's scenario with its scan period.
[[nodiscard]] ScenarioSpec scenario_of(const Cell& cell);

}  // namespace mda
