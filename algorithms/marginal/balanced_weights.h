// Weights of a cluster, scaled so that sums over its events neither overflow nor vanish.
#pragma once

#include <vector>

#include "algorithms/backends/assignment.h"
#include "algorithms/marginal/scan_weights.h"

namespace mda {

/// An event weighs the product over its pairs, its free tracks and its free plots. All factors are
/// in [0, 1], and those of the most probable event are 1: the sum over all events is 1 at least,
/// and a product that underflows was of no account.
struct BalancedWeights {
  std::vector<double> pair;
  std::vector<double> free_track;
  std::vector<double> free_plot;
};

/// The scales are the dual prices of the most probable event, an optimal assignment. They cancel
/// in every probability. Costs what AssignmentSolver does; keeps its buffers.
class Balancer {
 public:
  /// The result lives until the next call.
  const BalancedWeights& balance(const Cluster& cluster);

 private:
  AssignmentSolver solver_;
  SparseCosts costs_;
  BalancedWeights weights_;
};

}  // namespace mda
