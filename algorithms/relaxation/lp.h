// The LP relaxation alone: a bound with its certificate, and the point that roundings start from.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// A basic optimum of the relaxation 0 <= x <= 1 by the primal simplex method, with its dual
/// multipliers. Takes every problem; if the relaxation is infeasible, so is the problem.
/// Source: Storms and Spieksma, section 3.2.
[[nodiscard]] std::unique_ptr<Associator> make_lp();

}  // namespace mda
