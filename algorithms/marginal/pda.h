// Probabilistic data association: every track for itself.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// The marginals that a track would have if no other track wanted its plots: in proportion to the
/// weights of its pairs, against 1 for being in none. Not consistent: two tracks may be sure of one
/// plot. Exact where no plot is in two tracks' gates. O(nonzeros). Source: Bar-Shalom and Tse,
/// "Tracking in a cluttered environment with probabilistic data association", Automatica 11 (1975).
[[nodiscard]] std::unique_ptr<Associator> make_pda();

}  // namespace mda
