#include "algorithms/backends/assignment_flow.h"

#include "algorithms/backends/junctions.h"
#include "algorithms/backends/one_sided.h"
#include "algorithms/backends/path_reduction.h"

namespace mda {

namespace {

/// Searches that move half as many prices as there are objects show that they will not stay local.
constexpr double kMoves = 0.5;
/// Where paths cannot start and end anywhere, prices have to move by what a whole path costs, and
/// an auction by steps takes longer than long searches.
constexpr double kMovesWithoutEnds = 150.0;

FlowResult disjoint_paths(const FlowGraph& graph) {
  const PathReduction reduction(graph);
  if (!reduction.fault().empty()) {
    FlowResult declined;
    declined.outcome = FlowOutcome::kDeclined;
    declined.reason = reduction.fault();
    declined.reason_node = reduction.fault_node();
    return declined;
  }
  OneSidedMatcher matcher(reduction.problem());
  matcher.match_hard(reduction.small_step(), reduction.lacks_ends() ? kMovesWithoutEnds : kMoves);
  return reduction.result(matcher);
}

}  // namespace

FlowResult assignment_flow(const FlowGraph& graph) {
  const JunctionSplit split(graph);
  if (!split.has_junctions()) return disjoint_paths(graph);
  return split.joined(disjoint_paths(split.graph()));
}

}  // namespace mda
