// The data association method of Storms and Spieksma for one window.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Solves the LP relaxation; an integral optimum (every value within 1e-6 of 0 or 1) is the answer
/// and proven optimal, any other is rounded by greedy_rounding(). The bound is that of the
/// relaxation. Source: Storms and Spieksma, section 3.2.
[[nodiscard]] std::unique_ptr<Associator> make_lp_grp();

#ifdef MDA_WITH_LPSOLVE
/// The same, the relaxation solved by lp_solve, the paper's own package. Its bound is claimed, not
/// certified.
[[nodiscard]] std::unique_ptr<Associator> make_lpsolve_lp_grp();
#endif

}  // namespace mda
