// The optimum by the shortest way: the LP relaxation first, branch and bound only where it is
// fractional.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// A connected component of the row-column graph whose LP values are all integral (within 1e-6)
/// keeps them; every other component goes to COIN-OR CBC on its own. Takes every problem and can
/// prove that it has no answer.
///
/// The multipliers are those of the LP relaxation and certify its bound; the claimed bound is that
/// of the branch and bound. When the deadline comes during the LP there is no answer; later, every
/// component gets the best choice found for it. One without a choice stays empty; if it has
/// exactly-once rows, there is no answer.
/// Source: the model of Storms and Spieksma, section 3; components as in clustering for multiple
/// hypothesis tracking (Reid).
[[nodiscard]] std::unique_ptr<Associator> make_exact();

}  // namespace mda
