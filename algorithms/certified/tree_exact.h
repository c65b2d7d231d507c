// The optimum of a window, proven, without a general solver of integer programmes.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Stage by stage, until bound and choice meet:
///   packing            the window in whole numbers, its columns in trees
///   ascent             prices of rows by coordinate ascent, a greedy choice
///   swap_search        better choices
///   pricing, parts     columns that no better choice can have go; what is left falls apart
///   enumeration        of small parts
///   column_generation  the LP of the others; then choices, fixing and parts once more
///   kernel_search      cuts, then branch and bound
///
/// Takes always feasible problems. A finished run hands over a certificate (api/certificate.h). At
/// the deadline: the best choice found, the bound proven so far, and the multipliers of the best
/// prices. Costs are rounded as in certified/packing.h; the bound is less by what that can hide.
/// Exponential in the worst case; on windows whose LP is integral, about linear in the nonzeros.
[[nodiscard]] std::unique_ptr<Associator> make_tree_exact();

}  // namespace mda
