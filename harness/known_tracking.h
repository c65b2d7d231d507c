// Closed loop over known targets: how far every algorithm's tracks stray (Battistelli et al. 2008,
// section IV).
#pragma once

#include <atomic>

#include "harness/run_cell.h"

namespace mda {

/// A track is lost while it is farther than this from the ideal one (equation IV.3). The paper does
/// not print its threshold.
inline constexpr double kLostKm = 0.3;

/// Runs a cell of a known-target scenario once for each algorithm asked for, and reports a line of
/// tracking.jsonl for each. Algorithms whose answers are no selections, and those that decline a
/// window, are skipped with that reason. In a window without a usable answer all tracks
/// coast. Gives up between two windows once `interrupted` is set.
[[nodiscard]] CellReport run_known_cell(const Cell& cell, const Sweep& sweep, Worker& worker,
                                        int workers, const std::atomic<bool>& interrupted);

}  // namespace mda
