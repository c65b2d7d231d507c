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

/// The same for windows of known tracks, as S-D assignment sets its problem (Battistelli et al.
/// 2008, section II, equations II.2 and II.3): every track takes one sequence, its columns are
/// enumerated by gating. Declines windows in which tracks are born.
[[nodiscard]] std::unique_ptr<Associator> make_sd_exact();

}  // namespace mda
