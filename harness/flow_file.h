// Minimum-cost flow problems as text files, in two dialects.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/api/flow.h"

namespace mda {

/// What a file says, in the form that flow codes take. Arcs stand in the order of the file.
struct FlowFile {
  FlowGraph graph;           ///< lower bounds shifted into the supplies, integer costs
  std::vector<double> cost;  ///< per arc and unit, as in the file
  std::vector<std::int64_t>
      lower;  ///< per arc, flow beside that in `graph`; 0 in the tracking dialect
  std::vector<std::int64_t> line;  ///< per arc, from 1
  double cost_scale = 1.0;         ///< the costs in `graph` are round(cost * cost_scale)
  std::int64_t supplied = 0;       ///< sum of the positive supplies in the file
  [[nodiscard]] bool is_tracking() const noexcept { return graph.source >= 0; }
};

/// The graph in `text`, whose lines are words between blanks; nodes are numbered from 1.
///   c anything                  comment; blank lines are comments too
///   p min N M                   before what follows: N nodes, M arcs
///   n NODE SUPPLY
///   a TAIL HEAD LOW CAP COST    DIMACS: integers, 0 <= LOW <= CAP; supplies sum to 0
///   a TAIL HEAD COST            tracking: a real cost, capacity 1, no cycles
/// All arc lines are of one kind, which tells the dialects apart; a graph without arcs is DIMACS.
/// In the tracking dialect there are two `n` lines, the source's and the sink's, whatever their
/// supplies: any amount of flow may go from one to the other. Its costs are scaled by the largest
/// of 2^20, ..., 2^30 that keeps them in range for flow codes. Throws InputError, one sentence that
/// begins with `file` and the line's number. O(size of text).
[[nodiscard]] FlowFile parse_flow_file(std::string_view text, const std::string& file);

}  // namespace mda
