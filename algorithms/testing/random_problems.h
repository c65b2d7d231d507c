// Random association problems of all shapes, the same ones on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/api/problem.h"

namespace mda::testing {

struct RandomShape {
  int dimensions = 3;
  int rows_per_dimension = 3;
  int columns = 12;             ///< beside the single columns of `lone_columns`
  bool tracks = true;           ///< the first dimension is that of the fixed tracks
  double exactly_once = 0.0;    ///< share of the rows that must be used
  bool lone_columns = true;     ///< every exactly-once row gets a column of its own: feasible
  double presence = 0.7;        ///< chance that a column uses a given dimension
  int neighbourhood = 3;        ///< a column's rows lie within so many of each other
  bool integer_costs = false;   ///< many ties
  double positive_share = 0.2;  ///< of the columns
};

/// Some shape with at most `most_columns` (>= 15) columns and at most 14 rows: 1 to 6 dimensions,
/// with and without tracks, exactly-once rows and ties, sparse and dense. Every fourth shape with
/// exactly-once rows lacks the lone columns, so that its problems may be infeasible.
[[nodiscard]] RandomShape random_shape(std::uint64_t seed, int most_columns);

/// Costs are drawn from [-10, 0) or, for the positive share, [0, 5): generic reals, or whole nats
/// if the shape says so.
[[nodiscard]] AssociationProblem random_problem(const RandomShape& shape, std::uint64_t seed);

/// An odd cycle of columns, each sharing a row with the next: the relaxation takes half of each,
/// and no clique of columns tells that it should not. Costs are drawn from (-1.2, -1]. Exactly-once
/// rows get a column of their own at cost 0.
[[nodiscard]] AssociationProblem odd_cycle(int length, RowUse use, std::uint64_t seed);

/// The problems without a row in common: the optima add up.
[[nodiscard]] AssociationProblem side_by_side(const std::vector<AssociationProblem>& problems);

/// The same problem with its rows and its columns in another order. `column_to`, if given, gets the
/// new number of every column.
[[nodiscard]] AssociationProblem reorder(const AssociationProblem& problem, std::uint64_t seed,
                                         std::vector<int>* column_to = nullptr);

/// The same problem with every cost replaced by factor * cost + shift * (1 if the column uses
/// `row`, else 0).
[[nodiscard]] AssociationProblem with_costs(const AssociationProblem& problem, double factor,
                                            double shift = 0.0, int row = -1);

}  // namespace mda::testing
