// The relaxation, or branch and bound, by lp_solve 5.5: the package of Storms & Spieksma 2003.
// Built with -DMDA_WITH_LPSOLVE=ON only.
#pragma once

#include "algorithms/api/associator.h"
#include "algorithms/backends/run.h"

namespace mda {

/// With lp_solve's default settings, gaps 0, no limit of depth. Looks at the budget's deadline now
/// and then while it solves. Throws std::runtime_error if lp_solve gives up.
[[nodiscard]] LibraryRun lpsolve(const AssociationProblem& problem, bool integer,
                                 const Budget& budget);

}  // namespace mda
