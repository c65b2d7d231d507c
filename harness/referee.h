// The referee trusts no solver: it recomputes costs, feasibility and bounds from the problem and
// the answer alone.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algorithms/api/problem.h"
#include "algorithms/api/solution.h"

namespace mda {

/// A row broken by more than this refutes an answer.
inline constexpr double kRowTolerance = 1e-6;
/// A value within this distance of 0 or 1 counts as 0 or 1.
inline constexpr double kIntegralTolerance = 1e-6;

/// What x is worth, whoever made it.
struct Examination {
  /// One finite number in [0, 1] (within 1e-9) for every column, and tuples of known cost.
  bool well_formed = false;
  double cost = 0.0;           ///< nats
  double row_violation = 0.0;  ///< of the worst row, 0 if all hold
  int fractional = 0;          ///< columns farther than kIntegralTolerance from 0 and 1
  int paper_fractional = 0;    ///< and plot rows whose slack is so

  [[nodiscard]] bool feasible() const { return well_formed && row_violation <= kRowTolerance; }
  /// Feasible, and every column is used or not.
  [[nodiscard]] bool is_choice() const { return feasible() && fractional == 0; }
};

/// What x and the sequences beside it are worth. A tuple is well formed if it names a track's row
/// (in windows of sensors: none) and for each scan a plot's row of that scan or none, and if the
/// problem's views know its finite cost. O(nonzeros), and whatever TupleCost takes.
[[nodiscard]] Examination examine(const AssociationProblem& problem, std::span<const double> x,
                                  std::span<const Tuple> tuples = {});

/// What is wrong with the ranked choices of a solution, or an empty text: the first is not x, one
/// breaks a row or names no column, one is there twice, or a cheaper one follows.
[[nodiscard]] std::string ranking_fault(const AssociationProblem& problem,
                                        const Solution& solution);

/// The costs of the ranked choices, in order; NaN for one that names no column.
[[nodiscard]] std::vector<double> ranked_costs(const AssociationProblem& problem,
                                               std::span<const Choice> ranked);

/// The lower bound that row multipliers certify (see AssociationProblem's header):
/// L(u) = -sum_r u_r + sum_j min(0, c_j + sum_{r in j} u_r), valid for any u that is not negative
/// on at-most-once rows (negative ones count as 0), less a margin of 1e-9 (1 + sum of all terms'
/// sizes) for rounding. Empty when there is not one finite multiplier per row. O(nonzeros).
[[nodiscard]] std::optional<double> certified_bound(const AssociationProblem& problem,
                                                    std::span<const double> row_dual);

/// The best that is known of a problem after all algorithms have had their turn.
struct Knowledge {
  double best_choice_cost = std::numeric_limits<double>::infinity();
};

/// Why a solution is refuted, or an empty text: x is malformed or breaks a row; it was claimed
/// optimal, but a cheaper choice is known; or its claimed bound is NaN or lies above the best known
/// choice.
[[nodiscard]] std::string refutation(const Solution& solution, const Examination& examined,
                                     const Knowledge& known);

}  // namespace mda
