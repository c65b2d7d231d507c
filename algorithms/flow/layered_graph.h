// The layered graph on which association becomes a single-commodity flow.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/api/flow.h"
#include "algorithms/api/problem.h"

namespace mda {

/// Which of the predecessors of a node, if several reach it by arcs of the same least cost, its
/// estimate comes from. All missed detections of a window may cost the same, so this is no rarity.
enum class TieRule : std::uint8_t {
  /// What the printed formula gives: the lowest index. Missed-detection nodes come before plots, so
  /// a missed node, then, continues the missed node of its own index. Between plots the formula
  /// would follow the order of the input; here V decides.
  kLiteral,
  /// V, the cost of the best partial path to the predecessor, then the lowest index.
  kCumulative
};

struct LayeredNode {
  int row = kNoRow;         ///< of the plot, or of the track that a missed node is named after
  bool plot = false;        ///< otherwise a missed detection, or in layer 0 a track
  int tree_node = kNoNode;  ///< the best partial path to here, whose end is the node's estimate
  int miss_row = kNoRow;    ///< track of the only missed node that a missed detection may lead to
  double cumulative = 0.0;  ///< V, the cost of that path in this window, nats
};

struct LayeredArc {
  int tail = 0;
  int head = 0;
  double cost = 0.0;  ///< nats
};

/// Nodes are numbered by layer, in a layer missed nodes before plots, both by row; only nodes that
/// some gate lets a track reach are there. The destination is the number after the last node. Arcs
/// are in the order of their tails and lead from lower to higher numbers.
struct LayeredGraph {
  std::vector<int> layer_begin;  ///< K + 2 entries: the first node of layer k; all nodes
  std::vector<LayeredNode> nodes;
  std::vector<LayeredArc> arcs;

  [[nodiscard]] int tracks() const { return layer_begin[1]; }
  [[nodiscard]] int destination() const { return static_cast<int>(nodes.size()); }
  /// K.
  [[nodiscard]] int scans() const { return static_cast<int>(layer_begin.size()) - 2; }
};

/// Layer 0 has the fixed tracks of the problem's hypothesis tree, layer k the plots of scan k and
/// one missed node per track, for a path to miss the scan on. The estimate x^(i_k) of a node is
/// that of its best partial path, which is one node of the tree: the child, by this plot or missed
/// detection, of the representative of j* = argmin_j C(j_{k-1}, i_k). The arcs that leave a node
/// are the children of its representative. A plot node j leads to one missed node: that of the
/// missed node l of the layer before with the least C(l, j), or, if no gate lets one reach j, that
/// of the track its own best partial path starts from.
///
/// A track that may be dropped (its row is at-most-once) has an arc to the destination that costs
/// nothing. The arcs of layer 0 carry what the track has cost before the window, after the argmin.
///
/// Beyond the paper: missed detections cost what the tree says, so a track that cannot miss any
/// more lacks that arc. O(arcs). Source: Battistelli et al. 2008, section III.
[[nodiscard]] LayeredGraph layered_graph(const AssociationProblem& problem, TieRule rule);

/// One such graph per fixed track, as if it were alone: the commodities of the multi-commodity
/// flow. Estimates then come from the track's own sequences, and all its missed detections of a
/// scan share one node.
[[nodiscard]] std::vector<LayeredGraph> layered_graphs_by_track(const AssociationProblem& problem,
                                                                TieRule rule);

/// The graph for flow codes: every node of a layer above 0 is split into two and an arc of capacity
/// 1 (equation III.5), every track supplies one unit, the destination demands them all. The first
/// arcs are those of `graph`, in its order. Nodes are in topological order.
///
/// Costs are whole multiples of a power of 2 of a nat, the smallest from 2^-30 to 2^-20 whose
/// numbers are in range for all codes. Each of the at most T(K + 1) arcs with flow is rounded by
/// half a unit, so the flow costs at most T(K + 1) units more than the best one.
[[nodiscard]] FlowGraph flow_graph(const LayeredGraph& graph);

/// What each track does in a flow on the arcs of `graph` (in its order): the sequence along the
/// path that starts at the track, whatever nodes it uses. Tracks that are dropped, or
/// have no flow, have none.
[[nodiscard]] std::vector<Tuple> sequences(const LayeredGraph& graph,
                                           const std::vector<std::int64_t>& flow);

}  // namespace mda
