#include "harness/flow_paths.h"

#include <cstddef>

namespace mda {
namespace {

constexpr std::int64_t kNone = -1;

std::size_t index(std::int64_t i) { return static_cast<std::size_t>(i); }

/// The arcs that carry flow, listed by their tails.
class UsedArcs {
 public:
  UsedArcs(const FlowGraph& graph, const std::vector<std::int64_t>& flow)
      : first_(index(graph.nodes), kNone), after_(flow.size(), kNone) {
    for (std::size_t a = flow.size(); a-- > 0;) {
      if (flow[a] == 0) continue;
      std::int64_t& first = first_[index(graph.arcs[a].tail)];
      after_[a] = first;
      first = static_cast<std::int64_t>(a);
    }
  }

  /// The next arc out of a node that was not taken before, or kNone.
  std::int64_t take(int node) {
    std::int64_t& first = first_[index(node)];
    const std::int64_t arc = first;
    if (arc != kNone) first = after_[index(arc)];
    return arc;
  }

 private:
  std::vector<std::int64_t> first_;  ///< per node
  std::vector<std::int64_t> after_;  ///< per arc
};

}  // namespace

std::vector<std::vector<int>> paths_of_flow(const FlowFile& file,
                                            const std::vector<std::int64_t>& flow) {
  const FlowGraph& graph = file.graph;
  UsedArcs used(graph, flow);
  std::vector<std::vector<int>> paths;
  for (std::int64_t arc = used.take(graph.source); arc != kNone; arc = used.take(graph.source)) {
    std::vector<int> path = {graph.source};
    for (; arc != kNone; arc = used.take(path.back())) path.push_back(graph.arcs[index(arc)].head);
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace mda
