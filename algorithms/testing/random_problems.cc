#include "algorithms/testing/random_problems.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/testing/draw.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

double random_cost(const RandomShape& shape, Draw& draw) {
  const double cost = draw.chance(shape.positive_share) ? 5.0 * draw.unit() : -10.0 * draw.unit();
  return shape.integer_costs ? std::floor(cost) : cost;
}

/// Rows of dimension d are numbered d * rows_per_dimension onwards.
std::vector<int> random_rows(const RandomShape& shape, Draw& draw) {
  const int n = shape.rows_per_dimension;
  const int centre = draw.below(n);
  std::vector<int> rows;
  for (int d = 0; d < shape.dimensions; ++d) {
    if (!draw.chance(shape.presence)) continue;
    rows.push_back(d * n + (centre + draw.below(shape.neighbourhood)) % n);
  }
  if (rows.empty()) rows.push_back(draw.below(shape.dimensions * n));
  return rows;
}

}  // namespace

RandomShape random_shape(std::uint64_t seed, int most_columns) {
  constexpr int kMostRows = 14;
  Draw draw(seed);
  RandomShape shape;
  shape.dimensions = 1 + draw.below(6);
  shape.rows_per_dimension = 1 + draw.below(std::min(5, kMostRows / shape.dimensions));
  shape.tracks = draw.chance(0.5);
  shape.presence = draw.chance(0.5) ? 0.4 : 0.9;
  shape.neighbourhood = 1 + draw.below(shape.rows_per_dimension);
  shape.integer_costs = draw.chance(0.3);
  shape.positive_share = draw.chance(0.1) ? 1.0 : 0.2;
  if (draw.chance(0.4)) shape.exactly_once = draw.chance(0.5) ? 0.3 : 1.0;
  shape.lone_columns = draw.chance(0.75);
  const int rows = shape.dimensions * shape.rows_per_dimension;
  const int lone = shape.exactly_once > 0.0 && shape.lone_columns ? rows : 0;
  shape.columns = draw.below(std::max(1, most_columns - lone) + 1);
  return shape;
}

AssociationProblem random_problem(const RandomShape& shape, std::uint64_t seed) {
  Draw draw(seed);
  ProblemBuilder builder;
  std::vector<int> lone;
  for (int d = 0; d < shape.dimensions; ++d) {
    for (int i = 0; i < shape.rows_per_dimension; ++i) {
      const bool must = draw.chance(shape.exactly_once);
      const int row = builder.add_row(shape.tracks ? d : d + 1,
                                      must ? RowUse::kExactlyOnce : RowUse::kAtMostOnce);
      if (must && shape.lone_columns) lone.push_back(row);
    }
  }
  for (const int row : lone) builder.add_column(random_cost(shape, draw), std::vector{row});
  for (int j = 0; j < shape.columns; ++j) {
    const std::vector<int> rows = random_rows(shape, draw);
    builder.add_column(random_cost(shape, draw), rows);
  }
  return builder.build();
}

AssociationProblem odd_cycle(int length, RowUse use, std::uint64_t seed) {
  Draw draw(seed);
  ProblemBuilder builder;
  for (int i = 0; i < length; ++i) {
    const int row = builder.add_row(i + 1, use);
    if (use == RowUse::kExactlyOnce) builder.add_column(0.0, std::vector{row});
  }
  for (int i = 0; i < length; ++i) {
    builder.add_column(-1.0 - 0.2 * draw.unit(), std::vector{i, (i + 1) % length});
  }
  return builder.build();
}

AssociationProblem side_by_side(const std::vector<AssociationProblem>& problems) {
  ProblemBuilder builder;
  for (const AssociationProblem& problem : problems) {
    const int first_row = builder.rows();
    for (int r = 0; r < problem.rows(); ++r) builder.add_row(problem.dimension(r), problem.use(r));
    for (int j = 0; j < problem.columns(); ++j) {
      std::vector<int> rows;
      for (const int r : problem.rows_of(j)) rows.push_back(first_row + r);
      builder.add_column(problem.cost(j), rows);
    }
  }
  return builder.build();
}

AssociationProblem reorder(const AssociationProblem& problem, std::uint64_t seed,
                           std::vector<int>* column_to) {
  Draw draw(seed);
  ProblemBuilder builder;
  std::vector<int> row_to(index(problem.rows()));
  for (const int r : draw.permutation(problem.rows())) {
    row_to[index(r)] = builder.add_row(problem.dimension(r), problem.use(r));
  }
  if (column_to != nullptr) column_to->assign(index(problem.columns()), 0);
  for (const int j : draw.permutation(problem.columns())) {
    std::vector<int> rows;
    for (const int r : problem.rows_of(j)) rows.push_back(row_to[index(r)]);
    const int to = builder.add_column(problem.cost(j), rows);
    if (column_to != nullptr) (*column_to)[index(j)] = to;
  }
  return builder.build();
}

AssociationProblem with_costs(const AssociationProblem& problem, double factor, double shift,
                              int row) {
  ProblemBuilder builder;
  for (int r = 0; r < problem.rows(); ++r) builder.add_row(problem.dimension(r), problem.use(r));
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    const bool uses = std::find(rows.begin(), rows.end(), row) != rows.end();
    builder.add_column(factor * problem.cost(j) + (uses ? shift : 0.0), rows);
  }
  return builder.build();
}

}  // namespace mda::testing
