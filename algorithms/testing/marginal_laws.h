// The laws of answers that are probabilities.
#pragma once

#include <vector>

#include "algorithms/api/problem.h"
#include "algorithms/api/solution.h"

namespace mda::testing {

/// Whether the row is of the problem's lowest dimension: a fixed track or, in a problem without
/// any, a plot of the first scan.
[[nodiscard]] bool is_track(const AssociationProblem& problem, int row);

/// Expects that the probabilities of a track's columns add up to 1 at most, to 1 if the track is
/// exactly once, and if `consistent` those of a plot's to 1 at most.
void expect_distributions(const AssociationProblem& problem, const Solution& solution,
                          bool consistent);

/// Expects column j of the first answer to be as probable as column column_to[j] of the second.
void expect_close_marginals(const Solution& a, const Solution& b,
                            const std::vector<int>& column_to);

}  // namespace mda::testing
