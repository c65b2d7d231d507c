// The LP relaxation of a window by column generation on its trees.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Dual ascent, then certified/column_generation. A basic optimum of the LP, and the multipliers
/// that certify its value; after the deadline only these, with the bound they have reached. Costs
/// are rounded as in certified/packing.h.
[[nodiscard]] std::unique_ptr<Associator> make_cg_lp();

}  // namespace mda
