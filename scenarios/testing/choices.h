// Ways to choose columns, for tests and benchmarks: none of them needs an algorithm.
#pragma once

#include <span>
#include <vector>

#include "algorithms/api/problem.h"
#include "scenarios/hypotheses/extract.h"

namespace mda::testing {

/// The columns that fit, taken one after the other in the order given: no two share a row.
[[nodiscard]] std::vector<int> those_that_fit(const AssociationProblem& problem,
                                              std::span<const int> order);

/// The columns that fit, the cheapest first.
[[nodiscard]] std::vector<int> cheapest_that_fit(const AssociationProblem& problem);

/// The leaves that the columns stand for, false alarms left out.
[[nodiscard]] std::vector<int> leaves_of(const WindowInstance& window,
                                         std::span<const int> columns);

}  // namespace mda::testing
