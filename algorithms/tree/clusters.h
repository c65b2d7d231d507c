// A window's trees sorted into clusters, with costs that count from the choice without tracks.
#pragma once

#include <vector>

#include "algorithms/api/problem.h"

namespace mda {

/// What a row costs, and the column it takes, when it is left to itself: the cheapest column that
/// uses it alone (a fixed track that coasts, a false alarm that has to be told), or, on an
/// at-most-once row, nothing and kNoColumn if that is cheaper.
struct Leftover {
  double cost = 0.0;  ///< nats; infinite on an exactly-once row without such a column
  int column = kNoColumn;
};

struct Clusters {
  std::vector<Leftover> leftover;  ///< per row
  /// Per node, nats: the cost of the partial track minus that of its rows left to themselves. So
  /// the cost of any choice of columns is that of leaving all rows to themselves plus the worth of
  /// its leaves, and dropping a track costs minus its worth.
  std::vector<double> worth;
  std::vector<double> promise;  ///< per node: the least worth of the leaves it may become, nats
  /// [cluster][layer]: the roots in that layer, ascending: fixed tracks in layer 0, births above.
  std::vector<std::vector<std::vector<int>>> roots;

  [[nodiscard]] int size() const noexcept { return static_cast<int>(roots.size()); }
};

/// The connected components of the problem, which share no row, as clusters of trees. Without
/// columns there are none. Only for always feasible problems with a tree. O(nonzeros + nodes).
/// Source of clustering: Reid 1979, An algorithm for tracking multiple targets, IEEE Transactions
/// on Automatic Control 24, section IV.
[[nodiscard]] Clusters clusters_of(const AssociationProblem& problem);

}  // namespace mda
