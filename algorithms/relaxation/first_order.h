// Windows by first-order steps on their LP relaxation.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"
#include "algorithms/relaxation/primal_dual.h"

namespace mda {

/// Component by component: primal_dual(), then greedy_rounding() of its x. The multipliers certify
/// the bound; a choice whose cost meets it is claimed to be optimal. Always feasible problems with
/// any number of dimensions will do. They are brought into their normal form first, in which the
/// largest cost is between 1/2 and 1, so that neither order nor unit of cost matters.
/// Stop::kIterationLimit where some component has not settled; bound and choice hold even so.
/// O(iterations * nonzeros) and the rounding.
[[nodiscard]] std::unique_ptr<Associator> make_first_order(const PrimalDualOptions& options);

/// `mapada` on any window: alpha = 0.02. The quadratic term spreads x over
/// columns of like cost and loosens the bound. Source: Lee and Jeong, "Adaptive data association
/// for multi-target tracking using relaxation" (1998), section III, equation (16); the clipping and
/// the window are ours.
[[nodiscard]] std::unique_ptr<Associator> make_mapada_window();

/// alpha = 0: the relaxation itself. Source: Chambolle and Pock (2011), see primal_dual.h.
[[nodiscard]] std::unique_ptr<Associator> make_pdhg();

}  // namespace mda
