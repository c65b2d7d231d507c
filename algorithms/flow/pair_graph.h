// The graph on which tracks that are born in a window become a flow.
#pragma once

#include <vector>

#include "algorithms/api/problem.h"

namespace mda {

/// A birth at a plot, or the last two plots (i, j) of a track that was born: one plot may carry no
/// velocity, so costs that depend on the last plot alone would be those of tracks just born.
struct PairNode {
  int before = kNoRow;      ///< row of plot i; kNoRow: the track is born at j
  int last = kNoRow;        ///< row of plot j
  int scan = 0;             ///< of plot j
  int tree_node = kNoNode;  ///< the best partial path that ends with these plots
};

/// The next plot of a track, the scans between missed; or the end of the window, all scans until
/// then missed.
struct PairArc {
  int tail = 0;
  int head = kEnd;
  double cost = 0.0;  ///< nats; of arcs from a birth, with that of the birth

  static constexpr int kEnd = -1;
};

/// Nodes are in the order of their scans. Arcs are in the order of their tails.
struct PairGraph {
  std::vector<PairNode> nodes;
  std::vector<PairArc> arcs;
};

/// The estimate of a pair is that of the best predecessor: the pair (h, i), or the birth at i,
/// whose own best partial path, followed by j, costs least. That path is a node of the hypothesis
/// tree, so the arcs that leave a pair are the plots that the tree lets follow. O(arcs x K).
[[nodiscard]] PairGraph pair_graph(const AssociationProblem& problem);

}  // namespace mda
