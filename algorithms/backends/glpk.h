// Branch and bound by GLPK. Built with -DMDA_WITH_RIVALS=ON only.
#pragma once

#include "algorithms/api/associator.h"
#include "algorithms/backends/run.h"

namespace mda {

/// With GLPK's default settings: the primal simplex method, then the integer optimiser. Stops soon
/// after the deadline. Throws std::runtime_error if GLPK gives up.
[[nodiscard]] LibraryRun glpk(const AssociationProblem& problem, const Budget& budget);

}  // namespace mda
