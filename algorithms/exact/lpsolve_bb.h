// Branch and bound by the paper's own package. Built with -DMDA_WITH_LPSOLVE=ON only.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Branch and bound by lp_solve 5.5 on the whole window; exponential in the worst case. The bound
/// is that of a finished search. Source: Storms and Spieksma, section 4 (there lp_solve 1.5).
[[nodiscard]] std::unique_ptr<Associator> make_lpsolve_bb();

}  // namespace mda
