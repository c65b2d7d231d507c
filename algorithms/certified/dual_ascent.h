// Dual ascent on its own: a lower bound and a choice, without LP and without search.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// DualAscent of certified/ascent.h. The choice is proven optimal where it meets the bound, which
/// the multipliers certify in any case. At the deadline it returns what it has.
[[nodiscard]] std::unique_ptr<Associator> make_dual_ascent();

}  // namespace mda
