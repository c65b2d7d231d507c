// Random packings with their optima, for the stages of the certified solver.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "algorithms/certified/packing.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"

namespace mda::testing {

/// Many columns on few rows: the optimum is known, and the LP is far from it.
inline AssociationProblem knot(std::uint64_t seed) {
  RandomShape shape;
  shape.dimensions = 3 + static_cast<int>(seed % 3);
  shape.rows_per_dimension = 15 / shape.dimensions;
  shape.columns = 40 + static_cast<int>(seed % 7) * 25;
  shape.tracks = seed % 2 == 0;
  shape.presence = seed % 4 < 2 ? 0.5 : 0.8;
  shape.neighbourhood = shape.rows_per_dimension;
  shape.positive_share = 0.1;
  shape.integer_costs = seed % 5 == 0;
  return random_problem(shape, seed);
}

/// The optimum in steps of the packing.
inline Steps optimum_of(const Packing& packing) {
  ProblemBuilder builder;
  for (int r = 0; r < packing.rows(); ++r) builder.add_row(r, RowUse::kAtMostOnce);
  for (int j = 0; j < packing.columns(); ++j) {
    const Steps units = packing.cost[static_cast<std::size_t>(j)] / kGrid;
    builder.add_column(static_cast<double>(units), packing.rows_of(j));
  }
  return static_cast<Steps>(*optimum(builder.build())) * kGrid;
}

inline bool is_choice(const Packing& packing, const std::vector<int>& columns) {
  std::vector<int> used(static_cast<std::size_t>(packing.rows()), 0);
  for (const int j : columns) {
    for (const int r : packing.rows_of(j)) {
      if (++used[static_cast<std::size_t>(r)] > 1) return false;
    }
  }
  return true;
}

/// Calls visit(packing, optimum, seed) with a hundred packings that have columns.
template <typename Visitor>
void for_each_packing(Visitor visit) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const WindowPacking window = pack(knot(seed));
    if (window.packing.columns() > 0) visit(window.packing, optimum_of(window.packing));
  }
}

}  // namespace mda::testing
