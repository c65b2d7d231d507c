// The flow of a tracking graph, told as tracks.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/flow_file.h"

namespace mda {

/// The nodes, numbered from 0, of each unit's way from the source to the sink of a tracking graph,
/// in the order of the file's arcs out of the source. Together they use every arc that carries flow
/// once. Where ways meet in a node, a flow does not tell which goes on where: any pairing is as
/// good. `flow` must be one that the referee accepts. O(nodes + arcs).
[[nodiscard]] std::vector<std::vector<int>> paths_of_flow(const FlowFile& file,
                                                          const std::vector<std::int64_t>& flow);

}  // namespace mda
