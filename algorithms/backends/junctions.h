// Nodes that several units may pass, taken apart so that no node carries more than one.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/api/flow.h"

namespace mda {

/// A junction is a node with several arcs in and several arcs out, all of capacity 1, that neither
/// makes nor takes flow. Each of its arcs gets an end of its own, and every end of an arc in is
/// linked to every end of an arc out at no cost: each end then carries one unit at most.
class JunctionSplit {
 public:
  /// The graph must outlive the split. O(nodes + arcs + links); junctions are left as they are if
  /// they would need more than 2^27 links.
  explicit JunctionSplit(const FlowGraph& graph);

  [[nodiscard]] bool has_junctions() const noexcept { return links_ > 0; }
  /// The graph without junctions, if there are any. Its first arcs are those of the graph, in
  /// order.
  [[nodiscard]] const FlowGraph& graph() const noexcept { return split_; }
  /// The answer to graph() as one to the graph that was split.
  [[nodiscard]] FlowResult joined(FlowResult result) const;

 private:
  void find_junctions();
  void split();

  const FlowGraph& whole_;
  std::vector<char> is_junction_;  ///< per node
  std::int64_t links_ = 0;
  FlowGraph split_;
  std::vector<int> junction_of_end_;  ///< per node of the split beyond those of the graph
};

}  // namespace mda
