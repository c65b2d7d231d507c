// The search that all callers of CBC share. Only for the sources of this folder: it takes Clp's
// model.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/backends/run.h"

class ClpSimplex;

namespace mda {

struct CbcSearch {
  Outcome outcome = Outcome::kDeadline;
  std::vector<double> best;  ///< the best point found, whole up to rounding; empty without one
  double lower_bound = -std::numeric_limits<double>::infinity();  ///< proven
  std::int64_t nodes = 0;
  std::int64_t iterations = 0;  ///< of the simplex method, without those at the root
};

/// Branch and bound from `root`, whose relaxation has been solved (CBC looks at the clock only
/// between nodes) and whose integer columns are marked and bounded. Stops soon after the deadline.
/// Throws std::runtime_error if CBC gives up for another reason.
[[nodiscard]] CbcSearch search_from(ClpSimplex& root, const Budget& budget);

}  // namespace mda
