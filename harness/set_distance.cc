#include "harness/set_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace mda {
namespace {

double squared_distance(const Position& a, const Position& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// Columns: the pairs nearer than c. Rows: the true positions, then the estimates.
AssociationProblem pairs_within(std::span<const Position> truth,
                                std::span<const Position> estimates, double c_squared) {
  ProblemBuilder builder;
  for (std::size_t i = 0; i < truth.size(); ++i) builder.add_row(1, RowUse::kAtMostOnce);
  for (std::size_t j = 0; j < estimates.size(); ++j) builder.add_row(2, RowUse::kAtMostOnce);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = 0; j < estimates.size(); ++j) {
      const double d_squared = squared_distance(truth[i], estimates[j]);
      if (d_squared >= c_squared) continue;
      builder.add_column(d_squared - c_squared,
                         std::array{static_cast<int>(i), static_cast<int>(truth.size() + j)});
    }
  }
  return builder.build();
}

}  // namespace

SetDistance set_distance(std::span<const Position> truth, std::span<const Position> estimates,
                         double cut_off, Associator& assignment) {
  const double c_squared = cut_off * cut_off;
  const AssociationProblem pairs = pairs_within(truth, estimates, c_squared);
  const Solution solution = assignment.solve(pairs, {});
  if (solution.status != Status::kOptimal) {
    throw std::runtime_error("set distance: the pairs could not be assigned");
  }
  SetDistance result;
  double assigned = 0.0;
  for (int j = 0; j < pairs.columns(); ++j) {
    if (solution.x[static_cast<std::size_t>(j)] < 0.5) continue;
    result.localisation_squared += pairs.cost(j) + c_squared;
    assigned += 1.0;
  }
  const auto true_count = static_cast<double>(truth.size());
  const auto estimate_count = static_cast<double>(estimates.size());
  result.missed_squared = 0.5 * c_squared * (true_count - assigned);
  result.false_squared = 0.5 * c_squared * (estimate_count - assigned);
  result.gospa =
      std::sqrt(result.localisation_squared + result.missed_squared + result.false_squared);
  const double larger = std::max(true_count, estimate_count);
  if (larger > 0.0) {
    result.ospa =
        std::sqrt((result.localisation_squared + c_squared * (larger - assigned)) / larger);
  }
  return result;
}

}  // namespace mda
