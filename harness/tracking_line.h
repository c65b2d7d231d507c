// What the lines of tracking.jsonl have in common, whatever moves.
#pragma once

#include <string_view>

#include "harness/json_line.h"
#include "harness/own_loop.h"
#include "harness/run_cell.h"

namespace mda {

/// The fields that name an outing: one algorithm over one replicate.
void write_outing_key(const Cell& cell, const Sweep& sweep, std::string_view algorithm,
                      JsonLine& line);

/// Its status, why, and the workers of the run. `ran`: something of it was measured.
void write_outing_fate(const OwnLoopTally& tally, bool ran, int workers, JsonLine& line);

}  // namespace mda
