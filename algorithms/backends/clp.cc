#include "algorithms/backends/clp.h"

#include <ClpSimplex.hpp>
#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "algorithms/backends/clp_deadline.h"

namespace mda {
namespace {

static_assert(std::is_same_v<CoinBigIndex, int>, "column_begins() is handed to Clp as it is");

/// Without columns, doing nothing is the only choice.
LpResult solve_without_columns(const AssociationProblem& problem) {
  LpResult result;
  result.outcome = problem.shape().has_exactly_once_rows ? Outcome::kInfeasible : Outcome::kOptimal;
  result.row_dual.assign(static_cast<std::size_t>(problem.rows()), 0.0);
  return result;
}

double dual_bound(const AssociationProblem& problem, const std::vector<double>& row_dual) {
  double bound = 0.0;
  for (const double u : row_dual) bound -= u;
  for (int j = 0; j < problem.columns(); ++j) {
    double reduced_cost = problem.cost(j);
    for (const int r : problem.rows_of(j)) reduced_cost += row_dual[static_cast<std::size_t>(r)];
    bound += std::min(0.0, reduced_cost);
  }
  return bound;
}

/// Clp's row price is the change of the optimum per unit of right-hand side, hence -u.
std::vector<double> multipliers(const AssociationProblem& problem, const double* row_price) {
  std::vector<double> row_dual(static_cast<std::size_t>(problem.rows()));
  for (int r = 0; r < problem.rows(); ++r) {
    const double u = -row_price[r];
    row_dual[static_cast<std::size_t>(r)] =
        problem.use(r) == RowUse::kAtMostOnce ? std::max(0.0, u) : u;
  }
  return row_dual;
}

}  // namespace

void LpRelaxation::load(const AssociationProblem& problem, ClpSimplex& model) {
  ones_.resize(static_cast<std::size_t>(std::max(problem.nonzeros(), problem.rows())), 1.0);
  row_lower_.clear();
  for (int r = 0; r < problem.rows(); ++r) {
    row_lower_.push_back(problem.use(r) == RowUse::kExactlyOnce ? 1.0 : -COIN_DBL_MAX);
  }
  model.setLogLevel(0);
  // At the default of 1e-7 per column, some hundred slightly negative columns add up to a row that
  // is visibly broken once they are set to 0.
  model.setPrimalTolerance(1e-9);
  // No upper bounds on the columns: the rows imply x <= 1, and bounds slow the simplex method down.
  model.loadProblem(problem.columns(), problem.rows(), problem.column_begins().data(),
                    problem.row_indices().data(), ones_.data(), nullptr, nullptr,
                    problem.costs().data(), row_lower_.data(), ones_.data());
}

LpResult LpRelaxation::solve(const AssociationProblem& problem, const Budget& budget) {
  LpResult result;
  result.outcome = Outcome::kDeadline;
  if (budget.expired()) return result;
  if (problem.columns() == 0) return solve_without_columns(problem);

  const auto start = Clock::now();
  ClpSimplex model;  // a new one each time: nothing of the last solve can leak into this one
  load(problem, model);
  bool stopped = false;
  const ClpDeadline handler(budget, stopped);
  model.passInEventHandler(&handler);
  result.translate_ms = milliseconds_since(start);

  // x = 0 is a feasible start unless rows must be filled. The convenience call initialSolve()
  // would be slower (presolve) and not thread safe (a static in its signal handling).
  model.primal();
  result.iterations = model.numberIterations();
  constexpr int kClpInfeasible = 1;
  if (stopped) return result;
  if (model.status() == kClpInfeasible) {
    result.outcome = Outcome::kInfeasible;
    return result;
  }
  if (!model.isProvenOptimal()) {
    throw std::runtime_error("Clp gave up with status " + std::to_string(model.status()));
  }
  result.outcome = Outcome::kOptimal;
  const std::span<const double> x(model.primalColumnSolution(), problem.costs().size());
  result.x.assign(x.begin(), x.end());
  for (double& value : result.x) value = std::clamp(value, 0.0, 1.0);
  result.row_dual = multipliers(problem, model.dualRowSolution());
  result.lower_bound = dual_bound(problem, result.row_dual);
  return result;
}

}  // namespace mda
