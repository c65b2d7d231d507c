// The k best choices of a window with nothing between them left out.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

struct MurtyOptions {
  int choices = 10;  ///< k, at least 1
};

/// Solution::ranked holds the k cheapest choices (sets of columns that break no row and fill the
/// exactly-once rows), all different, in order of cost and, where costs are equal, of their
/// columns; fewer if there are no more. Which of several equally cheap choices come k-th is left
/// open. A choice and the same with one column more are two choices. x is the first; bound,
/// multipliers and relaxation are those that `inner` gives for the whole problem.
///
/// The choices that are left after the best one are split into parts, by the first of its columns
/// that is missing, or, if none is, by having further ones; the best of every part is found by
/// `inner`, and the cheapest part is the next choice and is split in turn. Every connected
/// component is ranked alone, k - 1 splits for all of them together; then the lists are added up. A
/// part's problem has only those columns of the component that are still open. At most k - 1 + the
/// number of components splits, each with as many problems for `inner` as the choice has columns in
/// that component, at most.
///
/// `inner` must be exact, take every problem that consists of columns of the given one, and find
/// out that there is no answer. Until the deadline k' <= k choices may be proven: then only those
/// are ranked, and the status is kFeasible. If `inner` does not finish the first, its answer is
/// returned. Throws std::invalid_argument if there is no inner or k < 1. Source: Murty 1968, An
/// algorithm for ranking all the assignments in order of increasing cost, Operations Research 16;
/// Lawler 1972, Management Science 18, for any 0-1 problem.
[[nodiscard]] std::unique_ptr<Associator> make_murty_k(const MurtyOptions& options,
                                                       std::unique_ptr<Associator> inner);

}  // namespace mda
