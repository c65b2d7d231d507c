// CBC as its command line runs it. Built with -DMDA_WITH_RIVALS=ON only.
#pragma once

#include "algorithms/api/associator.h"
#include "algorithms/backends/run.h"

namespace mda {

/// What `cbc FILE -ratio 0 -solve` does after it has read the file. Calls from several threads wait
/// for each other. Stops soon after the deadline. Throws std::runtime_error if CBC gives up.
[[nodiscard]] LibraryRun cbc_main(const AssociationProblem& problem, const Budget& budget);

}  // namespace mda
