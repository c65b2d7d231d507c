#include "harness/referee.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mda {
namespace {

constexpr double kValueTolerance = 1e-9;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool is_fractional(double x) { return std::abs(x - std::round(x)) > kIntegralTolerance; }

bool well_formed(const AssociationProblem& problem, std::span<const double> x) {
  return x.size() == index(problem.columns()) && std::all_of(x.begin(), x.end(), [](double v) {
           return v >= -kValueTolerance && v <= 1.0 + kValueTolerance;
         });
}

}  // namespace

double cost_tolerance(double cost) { return 1e-5 + 1e-9 * std::abs(cost); }

Examination examine(const AssociationProblem& problem, std::span<const double> x) {
  Examination result;
  result.well_formed = well_formed(problem, x);
  if (!result.well_formed) return result;
  std::vector<double> used(index(problem.rows()), 0.0);
  for (int j = 0; j < problem.columns(); ++j) {
    const double value = x[index(j)];
    if (value == 0.0) continue;
    result.cost += problem.cost(j) * value;
    if (is_fractional(value)) ++result.fractional;
    for (const int r : problem.rows_of(j)) used[index(r)] += value;
  }
  result.paper_fractional = result.fractional;
  for (int r = 0; r < problem.rows(); ++r) {
    const double slack = 1.0 - used[index(r)];
    const double violation = problem.use(r) == RowUse::kExactlyOnce ? std::abs(slack) : -slack;
    result.row_violation = std::max(result.row_violation, violation);
    if (problem.dimension(r) > 0 && is_fractional(slack)) ++result.paper_fractional;
  }
  return result;
}

std::optional<double> certified_bound(const AssociationProblem& problem,
                                      std::span<const double> row_dual) {
  if (row_dual.size() != index(problem.rows())) return std::nullopt;
  std::vector<double> u(row_dual.begin(), row_dual.end());
  double bound = 0.0;
  double size = 1.0;
  for (int r = 0; r < problem.rows(); ++r) {
    double& multiplier = u[index(r)];
    if (!std::isfinite(multiplier)) return std::nullopt;
    if (problem.use(r) == RowUse::kAtMostOnce) multiplier = std::max(0.0, multiplier);
    bound -= multiplier;
    size += std::abs(multiplier);
  }
  for (int j = 0; j < problem.columns(); ++j) {
    double reduced_cost = problem.cost(j);
    for (const int r : problem.rows_of(j)) reduced_cost += u[index(r)];
    if (reduced_cost >= 0.0) continue;
    bound += reduced_cost;
    size -= reduced_cost;
  }
  return bound - 1e-9 * size;
}

std::string refutation(const Solution& solution, const Examination& examined,
                       const Knowledge& known) {
  const double best = known.best_choice_cost;
  if (solution.status == Status::kOptimal || solution.status == Status::kFeasible) {
    if (!examined.well_formed) return "x is not one number in [0, 1] per column";
    if (solution.answer == Answer::kSelection && examined.fractional > 0) {
      return fmt::format("{} columns are neither used nor unused", examined.fractional);
    }
    if (solution.answer != Answer::kMarginals && !examined.feasible()) {
      return fmt::format("a row is broken by {}", examined.row_violation);
    }
  }
  if (solution.status == Status::kOptimal && examined.cost > best + cost_tolerance(best)) {
    return fmt::format("claimed optimal at {}, but {} is known", examined.cost, best);
  }
  if (std::isnan(solution.lower_bound)) return "the claimed bound is not a number";
  if (solution.lower_bound > best + cost_tolerance(best)) {
    return fmt::format("claimed the bound {}, but {} is known", solution.lower_bound, best);
  }
  return {};
}

}  // namespace mda
