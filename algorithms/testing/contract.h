// The laws that every algorithm obeys, sorted by what its traits promise. Each function runs the
// algorithm and reports every broken law as a GoogleTest failure. A problem that the algorithm
// declines is passed over, but for the reason it must give.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "algorithms/api/associator.h"

namespace mda::testing {

/// Makes a new object of the algorithm under test.
using MakeAssociator = std::unique_ptr<Associator> (*)();

/// Alike bit for bit in all but times.
void expect_identical(const Solution& a, const Solution& b);

/// The rows hold, tuples included; a claim of an optimum is true; an exact algorithm makes it and
/// finds out when there is no choice; a bound is valid, certified by its multipliers, and, from an
/// exact algorithm, tight; a relaxation handed over is an optimum of the LP. The marginals of a
/// track (a row of the lowest dimension) add up to 1 at most, and to 1 if the track is exactly
/// once; those of a plot to 1 at most where the traits say so. `optimum`: of the problem, or
/// nothing.
void expect_lawful_answer(MakeAssociator make, const AssociationProblem& problem,
                          const std::optional<double>& optimum);

/// The same problem with its rows and columns (and tree) in another order: the same cost and bound.
/// Not for heuristics and roundings on problems with ties.
void expect_order_does_not_matter(MakeAssociator make, const AssociationProblem& problem,
                                  const AssociationProblem& reordered);

/// Marginals follow their columns: column j of the problem is column column_to[j] of the reordered
/// one.
void expect_marginals_follow(MakeAssociator make, const AssociationProblem& problem,
                             const AssociationProblem& reordered,
                             const std::vector<int>& column_to);

/// Costs times a power of 2: cost and bound times the same. As above on ties. Not of marginals:
/// other costs are other odds.
void expect_scaling(MakeAssociator make, const AssociationProblem& problem, double power_of_2);

/// A constant added to every column of an exactly-once row moves the cost of an exact answer, and
/// every bound, by as much; if the row is a track, it moves no marginal.
void expect_shift(MakeAssociator make, const AssociationProblem& problem, int exactly_once_row,
                  double shift_nats);

/// One object solving a, b, a answers a twice alike, bit for bit, and like a new object.
void expect_no_memory(MakeAssociator make, const AssociationProblem& a,
                      const AssociationProblem& b);

/// Objects on several threads answer the problems bit for bit like one alone: the libraries behind
/// them share no state.
void expect_threads_apart(MakeAssociator make, const std::vector<AssociationProblem>& problems);

/// With a deadline `microseconds` from now whatever is claimed is true, and the answer says why it
/// ended: at the deadline if that is over already (0 and less). `optimum` as above.
void expect_honest_deadline(MakeAssociator make, const AssociationProblem& problem,
                            const std::optional<double>& optimum, int microseconds);

}  // namespace mda::testing
