// The optimum of a tiny problem by trying every choice: the yardstick of the tests.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Visits every choice of columns that uses no row twice; declines problems of more than 25
/// columns. Takes every other problem and can prove that it has no answer. Of several optima it
/// returns the first in the order in which taking an early column comes before leaving it out.
/// O(2^columns) in the worst case. Source: the definition of the problem.
[[nodiscard]] std::unique_ptr<Associator> make_brute_force();

}  // namespace mda
