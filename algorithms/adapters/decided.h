// Makes a decision out of probabilities.
#pragma once

#include <memory>
#include <span>

#include "algorithms/api/associator.h"

namespace mda {

/// Chooses for every track (row of the lowest dimension) one of its columns or, if it is at most
/// once, nothing, so that the product of the chosen probabilities is largest and no plot is used
/// twice: an assignment problem in -ln of the probabilities, which `assignment` solves. A plot that
/// this leaves free takes its most probable column alone if it must take one, or if that is more
/// probable than nothing. `marginals`: one per column; they may contradict each other.
///
/// Nothing has the probability that the columns of the row leave. That is a difference: it, and
/// columns that use a track alone, count as 1e-15 at least, all others as 1e-300. O(nonzeros)
/// beside the assignment; what that answers if it finds no choice.
[[nodiscard]] Solution decide(const AssociationProblem& problem, std::span<const double> marginals,
                              Associator& assignment, const Budget& budget);

/// Solves the problem with `marginals`, then decides. Takes what `marginals` takes; an answer of
/// another kind than marginals is an error (std::logic_error).
[[nodiscard]] std::unique_ptr<Associator> make_decided(std::unique_ptr<Associator> marginals,
                                                       std::unique_ptr<Associator> assignment);

}  // namespace mda
