// Closed loop over targets seen as positions: how every algorithm's tracks keep to them (Lee &
// Jeong 1998, section IV).
#pragma once

#include <atomic>

#include "harness/run_cell.h"

namespace mda {

/// The algorithm of the lines of true association. No entry of the catalogue has this name.
inline constexpr std::string_view kOracle = "oracle";

/// Runs a cell once by the true association and once for each algorithm asked for, and reports a
/// line of tracking.jsonl for each. Answers that are choices move the tracks as they say, others as
/// values_to_follow() has it. Algorithms that decline a window are skipped with that reason. In a
/// window without a usable answer all tracks coast. An outing in which a track's covariance breaks
/// down is a failed line. Gives up between two windows once `interrupted` is set.
[[nodiscard]] CellReport run_position_cell(const Cell& cell, const Sweep& sweep, Worker& worker,
                                           int workers, const std::atomic<bool>& interrupted);

}  // namespace mda
