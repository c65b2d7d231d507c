// Closed loop: every algorithm drives its own windows over the same plots, and what counts is what
// becomes of the tracks.
#pragma once

#include <atomic>

#include "harness/run_cell.h"

namespace mda {

/// Cut-off of GOSPA and OSPA, km.
inline constexpr double kTrackingCutOffKm = 1.0;

/// Runs a cell once for each algorithm asked for, and reports a line of tracking.jsonl for each.
/// Algorithms whose answers are no selections are skipped with that reason. In a window without a
/// usable answer nothing is chosen. Gives up between two windows once `interrupted` is set.
[[nodiscard]] CellReport run_closed_cell(const Cell& cell, const Sweep& sweep, Worker& worker,
                                         int workers, const std::atomic<bool>& interrupted);

}  // namespace mda
