// manifest.json: everything needed to say what a run was and to run it again.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/run_cell.h"
#include "harness/sweep.h"

namespace mda {

/// How a run went. `end` is empty while it is going on.
struct RunRecord {
  std::vector<std::string> arguments;
  int workers = 1;
  int cells = 0;
  int cells_finished = 0;
  int cells_failed = 0;
  int open_loop_cells_failed = 0;
  std::string start;  ///< UTC, ISO 8601
  std::string end;
  std::string outcome = "running";  ///< then finished, interrupted or disk failure
  double parallel_ms = 0.0;         ///< wall clock of the parallel part
  Tally tally;
};

/// UTC now, as 2001-02-03T04:05:06Z.
[[nodiscard]] std::string utc_now();

[[nodiscard]] nlohmann::ordered_json manifest(const Sweep& sweep, const RunRecord& record);

/// trajectories.json: where known targets truly are, km, by scenario, at its own scan period. Empty
/// without such scenarios.
[[nodiscard]] nlohmann::ordered_json trajectories(const Sweep& sweep);

/// Sum of the cells' wall times over the wall time of the parallel part; 0 before the end.
[[nodiscard]] double speed_up(const RunRecord& record);

/// What is neither simulation nor hypotheses nor solving, as a share of the cells' CPU time.
[[nodiscard]] double other_share(const RunRecord& record);

}  // namespace mda
