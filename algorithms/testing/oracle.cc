#include "algorithms/testing/oracle.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t mask_of(std::span<const int> rows) {
  std::size_t mask = 0;
  for (const int r : rows) mask |= std::size_t{1} << index(r);
  return mask;
}

}  // namespace

std::optional<double> optimum(const AssociationProblem& problem) {
  assert(problem.rows() <= 20);
  // least[s]: the least cost of a choice that uses exactly the rows of s. A column uses a row, so
  // no choice takes it twice, and the table can be updated in place.
  std::vector<double> least(std::size_t{1} << index(problem.rows()), kInfinity);
  least[0] = 0.0;
  for (int j = 0; j < problem.columns(); ++j) {
    const std::size_t mask = mask_of(problem.rows_of(j));
    for (std::size_t used = 0; used < least.size(); ++used) {
      if ((used & mask) != 0) continue;
      least[used | mask] = std::min(least[used | mask], least[used] + problem.cost(j));
    }
  }
  std::size_t must = 0;
  for (int r = 0; r < problem.rows(); ++r) {
    if (problem.use(r) == RowUse::kExactlyOnce) must |= std::size_t{1} << index(r);
  }
  double best = kInfinity;
  for (std::size_t used = 0; used < least.size(); ++used) {
    if ((used & must) == must) best = std::min(best, least[used]);
  }
  return std::isfinite(best) ? std::optional(best) : std::nullopt;
}

double cost_of(const AssociationProblem& problem, std::span<const double> x) {
  double cost = 0.0;
  for (int j = 0; j < problem.columns(); ++j) cost += problem.cost(j) * x[index(j)];
  return cost;
}

double row_violation(const AssociationProblem& problem, std::span<const double> x) {
  std::vector<double> use(index(problem.rows()), 0.0);
  for (int j = 0; j < problem.columns(); ++j) {
    for (const int r : problem.rows_of(j)) use[index(r)] += x[index(j)];
  }
  double worst = 0.0;
  for (int r = 0; r < problem.rows(); ++r) {
    worst = std::max(worst, use[index(r)] - 1.0);
    if (problem.use(r) == RowUse::kExactlyOnce) worst = std::max(worst, 1.0 - use[index(r)]);
  }
  return worst;
}

double certified_bound(const AssociationProblem& problem, std::span<const double> u) {
  std::vector<double> reduced(problem.costs().begin(), problem.costs().end());
  double bound = 0.0;
  for (int j = 0; j < problem.columns(); ++j) {
    for (const int r : problem.rows_of(j)) reduced[index(j)] += u[index(r)];
    if (reduced[index(j)] < 0.0) bound += reduced[index(j)];
  }
  for (const double multiplier : u) bound -= multiplier;
  return bound;
}

double tolerance(const AssociationProblem& problem) {
  double scale = 1.0;
  for (const double c : problem.costs()) scale += std::abs(c);
  return 1e-7 * scale;
}

}  // namespace mda::testing
