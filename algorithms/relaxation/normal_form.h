// A problem brought into the form that the Lagrangian methods iterate on, so that what they do
// depends on neither the order of rows and columns nor the unit of cost.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algorithms/api/problem.h"

namespace mda {

/// One component: choose columns so that every row is used at most once. All costs are negative.
struct NormalComponent {
  std::vector<int> row_level;  ///< per row: its dimension, counted without gaps, ascending
  std::vector<int> column_begin;
  std::vector<int> row_index;  ///< rows of column j: from column_begin[j], ascending
  std::vector<double> cost;    ///< in (-1, 0), multiples of 2^-40
  std::vector<int> row;        ///< the problem's number of every row
  std::vector<int> column;     ///< and of every column

  [[nodiscard]] std::span<const int> rows_of(int j) const {
    const auto first = static_cast<std::size_t>(column_begin[static_cast<std::size_t>(j)]);
    const auto last = static_cast<std::size_t>(column_begin[static_cast<std::size_t>(j) + 1]);
    return {row_index.data() + first, last - first};
  }
  [[nodiscard]] int rows() const noexcept { return static_cast<int>(row.size()); }
  [[nodiscard]] int columns() const noexcept { return static_cast<int>(column.size()); }
  [[nodiscard]] int levels() const noexcept { return row_level.empty() ? 0 : row_level.back() + 1; }
};

/// An always feasible problem without what no optimum needs. An exactly-once row is charged for its
/// cheapest column alone in advance; then it is used at most once like the others, and only columns
/// that are still negative can gain anything.
struct NormalForm {
  double unit = 1.0;                  ///< nats per unit of cost, a power of 2
  std::vector<double> charge;         ///< per row of the problem, nats; 0 on at-most-once rows
  std::vector<int> column_of_charge;  ///< per row of the problem, or kNoColumn
  std::vector<NormalComponent> components;

  /// The problem's multipliers that prove what `multiplier` (per row of the problem, not negative,
  /// in units) proves about the normal form. Not negative on at-most-once rows.
  [[nodiscard]] std::vector<double> row_dual(const std::vector<double>& multiplier) const;

  /// `chosen` columns of the problem and those that fill the exactly-once rows which they leave
  /// free.
  [[nodiscard]] std::vector<int> completed(const AssociationProblem& problem,
                                           std::vector<int> chosen) const;
};

/// What multipliers u, not negative on at-most-once rows, prove, nats:
/// -sum_r u_r + sum_j min(0, c_j + sum_{r in j} u_r). O(nonzeros).
[[nodiscard]] double lagrangian_bound(const AssociationProblem& problem,
                                      std::span<const double> row_dual);

/// Rows and columns come in an order that depends on the structure and the costs only, as far as
/// four rounds of hashing tell them apart: an order that tells nobody which row was added first.
/// Costs are rounded to 2^-40 of the largest, so that adding a constant to an exactly-once row
/// leaves the normal form, in practice, as it was. Throws std::invalid_argument when an
/// exactly-once row has no column of its own. O(nonzeros + columns log columns).
[[nodiscard]] NormalForm normal_form(const AssociationProblem& problem);

}  // namespace mda
