// The integer programme of a whole window by branch and bound.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// COIN-OR CBC with clique cuts on all columns at once. Takes every problem and can prove that it
/// has no answer. At the deadline it returns the best choice found so far, if there is one, and the
/// bound proven so far. CBC looks at the clock between the steps of its search, not within the
/// linear programmes of strong branching: on large dense problems it may be late by a few of these.
/// Source: Storms and Spieksma, section 4 (the Branch & Bound columns of its tables).
[[nodiscard]] std::unique_ptr<Associator> make_branch_and_bound();

}  // namespace mda
