#include "algorithms/api/views.h"

namespace mda {

void index_children(HypothesisTree& tree) {
  const auto nodes = static_cast<std::size_t>(tree.nodes());
  tree.child_begin.assign(nodes, 0);
  tree.child_end.assign(nodes, 0);
  for (std::size_t node = 0; node < nodes; ++node) {
    if (tree.parent[node] == kNoNode) continue;
    const auto parent = static_cast<std::size_t>(tree.parent[node]);
    if (tree.child_end[parent] == 0) tree.child_begin[parent] = static_cast<int>(node);
    tree.child_end[parent] = static_cast<int>(node) + 1;
  }
}

}  // namespace mda
