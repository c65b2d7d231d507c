// What an answer to a window of one scan makes its tracks do: a value for every column, at most 1
// per track, 0 throughout for a track that coasts.
#pragma once

#include <span>
#include <vector>

#include "algorithms/api/associator.h"
#include "scenarios/spec.h"

namespace mda {

/// The column of every track row with the largest value, kNoColumn for a track without columns; of
/// several the first. Two of them may use one plot. Needs a problem with pairs. O(pairs).
[[nodiscard]] std::vector<int> largest_by_track(const AssociationProblem& problem,
                                                std::span<const double> x);

/// Whether two of the columns use the same plot.
[[nodiscard]] bool are_in_conflict(const AssociationProblem& problem, std::span<const int> columns);

/// A solution's x as the tracks are to follow it: a choice, and marginals that are all 0 or 1, as
/// they are; a relaxation by the largest value of every track for itself; other marginals as they
/// are (soft) or as decided() has it (hard). Throws std::runtime_error if that finds no choice.
[[nodiscard]] std::vector<double> values_to_follow(const AssociationProblem& problem,
                                                   const Solution& solution, TrackUpdate update);

}  // namespace mda
