// From a point of the LP relaxation to a choice of columns.
#pragma once

#include <span>
#include <vector>

#include "algorithms/api/problem.h"

namespace mda {

/// Values within this distance of the largest one count as tied with it.
inline constexpr double kRoundingTie = 1e-9;

/// The greedy rounding procedure (GRP) of Storms and Spieksma, section 3.2. Returns the chosen
/// columns, ascending.
///
/// `x` holds one value in [0, 1] per column. Only columns that have a negative cost or use an
/// exactly-once row take part, also those at 0; any other could be dropped from the result at a
/// gain. In each step the column of the largest value that is still free is chosen, of several tied
/// ones the cheapest, of equally cheap ones the first; then every column that shares a row with it
/// is discarded. Values below kRoundingTie count as 0.
///
/// The choice uses no row twice, leaves no column of negative cost whose rows are all free, and
/// fills every exactly-once row that some column uses alone. With f fractional values:
/// O(nonzeros + f^2 + columns log columns).
[[nodiscard]] std::vector<int> greedy_rounding(const AssociationProblem& problem,
                                               std::span<const double> x);

}  // namespace mda
