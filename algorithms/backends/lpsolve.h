// The relaxation, or branch and bound, by lp_solve 5.5: the package of Storms & Spieksma 2003.
// Built with -DMDA_WITH_LPSOLVE=ON only.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/backends/run.h"

namespace mda {

struct LpSolveResult {
  Outcome outcome = Outcome::kDeadline;
  std::vector<double> x;   ///< one per column, in [0, 1]; at the deadline the incumbent or empty
  double objective = 0.0;  ///< of x, nats
  std::int64_t nodes = 0;
  std::int64_t iterations = 0;
  double translate_ms = 0.0;
};

/// With lp_solve's default settings, gaps 0, no limit of depth. Looks at the budget's deadline now
/// and then while it solves. Throws std::runtime_error if lp_solve gives up.
[[nodiscard]] LpSolveResult lpsolve(const AssociationProblem& problem, bool integer,
                                    const Budget& budget);

}  // namespace mda
