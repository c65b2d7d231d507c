// What the tests know about a problem without asking any algorithm.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/api/problem.h"
#include "algorithms/api/solution.h"

namespace mda::testing {

/// The least cost of any choice, or nothing if no choice fills the exactly-once rows. Dynamic
/// programming over the sets of used rows: O(columns * 2^rows), for at most 20 rows.
[[nodiscard]] std::optional<double> optimum(const AssociationProblem& problem);

/// Every choice that fills the rows, one by one, and what follows if each is as probable as
/// exp(-cost). Exponential in the columns.
struct GibbsDistribution {
  std::int64_t choices = 0;
  std::vector<double> probability;  ///< per column; 0 without a choice
};
[[nodiscard]] GibbsDistribution gibbs_distribution(const AssociationProblem& problem);

/// sum_j c_j x_j.
[[nodiscard]] double cost_of(const AssociationProblem& problem, std::span<const double> x);

/// The same with the solution's tuples, infinite if the problem's views do not know their cost.
[[nodiscard]] double cost_of(const AssociationProblem& problem, const Solution& solution);

/// How far x breaks the worst row, at least 0: the use above 1 of any row, and below 1 of an
/// exactly-once row.
[[nodiscard]] double row_violation(const AssociationProblem& problem, std::span<const double> x);

/// The same when the tuples use their rows too. Infinite if a tuple is not what it says: a fixed
/// track (none in windows of sensors) and, for every scan, one of its plots or none.
[[nodiscard]] double row_violation(const AssociationProblem& problem, const Solution& solution);

/// L(u) = -sum_r u_r + sum_j min(0, c_j + sum_{r in j} u_r): what the relaxation costs at least
/// when breaking a row is allowed at a price of u. A lower bound for every u that is not negative
/// on the at-most-once rows.
[[nodiscard]] double certified_bound(const AssociationProblem& problem, std::span<const double> u);

/// What rounding errors may amount to in sums over the costs of this problem.
[[nodiscard]] double tolerance(const AssociationProblem& problem);

}  // namespace mda::testing
