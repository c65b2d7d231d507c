#include "algorithms/backends/binary_program.h"

#include <ClpSimplex.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "algorithms/backends/cbc_search.h"
#include "algorithms/backends/clp.h"
#include "algorithms/backends/clp_deadline.h"

namespace mda {
namespace {

Outcome outcome_without_variables(const BinaryProgram& program) {
  bool feasible = true;
  for (const double lower : program.row_lower) feasible = feasible && lower <= 0.0;
  for (const double upper : program.row_upper) feasible = feasible && upper >= 0.0;
  return feasible ? Outcome::kOptimal : Outcome::kInfeasible;
}

void load(const BinaryProgram& program, ClpSimplex& model) {
  const std::vector<double> zeros(program.costs.size(), 0.0);
  const std::vector<double> ones(program.costs.size(), 1.0);
  model.setLogLevel(0);
  model.setPrimalTolerance(1e-9);
  model.loadProblem(static_cast<int>(program.costs.size()),
                    static_cast<int>(program.row_lower.size()), program.begins.data(),
                    program.rows.data(), program.coefficients.data(), zeros.data(), ones.data(),
                    program.costs.data(), program.row_lower.data(), program.row_upper.data());
  for (int j = 0; j < model.numberColumns(); ++j) model.setInteger(j);
}

/// On flow problems the dual simplex method is the more accurate one.
Outcome solve_relaxation(ClpSimplex& model, const Budget& budget) {
  bool stopped = false;
  const ClpDeadline handler(budget, stopped);
  model.passInEventHandler(&handler);
  model.dual();
  const ClpEventHandler none;
  model.passInEventHandler(&none);
  constexpr int kClpInfeasible = 1;
  if (stopped) return Outcome::kDeadline;
  if (model.status() == kClpInfeasible) return Outcome::kInfeasible;
  if (!model.isProvenOptimal()) {
    throw std::runtime_error("Clp gave up with status " + std::to_string(model.status()));
  }
  return Outcome::kOptimal;
}

}  // namespace

int BinaryProgram::add_row(double lower, double upper) {
  row_lower.push_back(std::isinf(lower) ? -COIN_DBL_MAX : lower);
  row_upper.push_back(std::isinf(upper) ? COIN_DBL_MAX : upper);
  return static_cast<int>(row_lower.size()) - 1;
}

int BinaryProgram::add_variable(double cost, std::span<const Entry> entries) {
  for (const Entry& entry : entries) {
    rows.push_back(entry.row);
    coefficients.push_back(entry.coefficient);
  }
  begins.push_back(static_cast<int>(rows.size()));
  costs.push_back(cost);
  return static_cast<int>(costs.size()) - 1;
}

BinaryResult solve_program(const BinaryProgram& program, Integrality integrality,
                           const Budget& budget) {
  BinaryResult result;
  if (budget.expired()) return result;
  if (program.costs.empty()) {
    result.outcome = outcome_without_variables(program);
    return result;
  }
  ClpSimplex model;
  load(program, model);
  result.outcome = solve_relaxation(model, budget);
  result.iterations = model.numberIterations();
  if (result.outcome != Outcome::kOptimal) return result;
  const double* x = model.primalColumnSolution();
  result.x.assign(x, x + program.costs.size());
  result.lp_fractional = static_cast<int>(
      std::count_if(result.x.begin(), result.x.end(), [](double v) { return !is_integral(v); }));
  if (integrality == Integrality::kBinary && result.lp_fractional > 0) {
    CbcSearch search = search_from(model, budget);
    result.outcome = search.outcome;
    result.x = std::move(search.best);
    result.iterations += search.iterations;
    result.nodes = search.nodes;
  }
  for (double& value : result.x) {
    value = is_integral(value) ? std::round(value) : std::clamp(value, 0.0, 1.0);
  }
  return result;
}

}  // namespace mda
