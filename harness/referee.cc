#include "harness/referee.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
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

bool fits(const AssociationProblem& problem, const Tuple& tuple) {
  const auto in = [&](int row, int dimension) {
    return row >= 0 && row < problem.rows() && problem.dimension(row) == dimension;
  };
  const bool of_sensors = problem.shape().has_sensors && tuple.track == kNoRow;
  if (!of_sensors && !in(tuple.track, 0)) return false;
  for (std::size_t k = 0; k < tuple.rows.size(); ++k) {
    if (tuple.rows[k] != kNoRow && !in(tuple.rows[k], static_cast<int>(k) + 1)) return false;
  }
  return std::ssize(tuple.rows) == problem.shape().dimensions - (of_sensors ? 0 : 1);
}

/// Adds the tuples' costs and rows; false if one of them is not well formed.
bool add_tuples(const AssociationProblem& problem, std::span<const Tuple> tuples,
                Examination& result, std::vector<double>& used) {
  const Views* views = problem.views();
  for (const Tuple& tuple : tuples) {
    if (views == nullptr || !views->tuple_cost || !fits(problem, tuple)) return false;
    const double cost = views->tuple_cost(tuple);
    if (!std::isfinite(cost)) return false;
    result.cost += cost;
    if (tuple.track != kNoRow) used[index(tuple.track)] += 1.0;
    for (const int row : tuple.rows) {
      if (row != kNoRow) used[index(row)] += 1.0;
    }
  }
  return true;
}

}  // namespace

Examination examine(const AssociationProblem& problem, std::span<const double> x,
                    std::span<const Tuple> tuples) {
  Examination result;
  std::vector<double> used(index(problem.rows()), 0.0);
  result.well_formed = well_formed(problem, x) && add_tuples(problem, tuples, result, used);
  if (!result.well_formed) return result;
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

std::string ranking_fault(const AssociationProblem& problem, const Solution& solution) {
  double cost_before = -std::numeric_limits<double>::infinity();
  std::set<Choice> seen;
  for (const Choice& choice : solution.ranked) {
    std::vector<double> x(index(problem.columns()), 0.0);
    for (const int j : choice) {
      if (j < 0 || j >= problem.columns()) return "a ranked choice names no column";
      x[index(j)] += 1.0;
    }
    if (seen.empty() && x != solution.x) return "the first ranked choice is not the answer";
    if (!seen.insert(choice).second) return "a ranked choice is there twice";
    const Examination examined = examine(problem, x);
    if (!examined.is_choice()) return "a ranked choice breaks a row";
    if (examined.cost < cost_before - cost_tolerance(cost_before)) {
      return fmt::format("a choice of {} is ranked after one of {}", examined.cost, cost_before);
    }
    cost_before = examined.cost;
  }
  return {};
}

std::vector<double> ranked_costs(const AssociationProblem& problem,
                                 std::span<const Choice> ranked) {
  std::vector<double> costs;
  for (const Choice& choice : ranked) {
    double cost = 0.0;
    for (const int j : choice) {
      const bool is_column = j >= 0 && j < problem.columns();
      cost += is_column ? problem.cost(j) : std::numeric_limits<double>::quiet_NaN();
    }
    costs.push_back(cost);
  }
  return costs;
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
