#include "algorithms/backends/cbc_main.h"

#include <CbcModel.hpp>
#include <CbcSolver.hpp>
#include <OsiClpSolverInterface.hpp>
#include <algorithm>
#include <array>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace mda {
namespace {

void load(const AssociationProblem& problem, OsiClpSolverInterface& solver) {
  std::vector<CoinBigIndex> begins(1, 0);
  std::vector<int> rows;
  std::vector<double> costs;
  for (int j = 0; j < problem.columns(); ++j) {
    for (const int r : problem.rows_of(j)) rows.push_back(r);
    begins.push_back(static_cast<CoinBigIndex>(rows.size()));
    costs.push_back(problem.cost(j));
  }
  std::vector<double> row_lower;
  for (int r = 0; r < problem.rows(); ++r) {
    row_lower.push_back(problem.use(r) == RowUse::kExactlyOnce ? 1.0 : -COIN_DBL_MAX);
  }
  const std::vector<double> ones(std::max({rows.size(), costs.size(), row_lower.size()}), 1.0);
  solver.messageHandler()->setLogLevel(0);
  solver.loadProblem(problem.columns(), problem.rows(), begins.data(), rows.data(), ones.data(),
                     nullptr, ones.data(), costs.data(), row_lower.data(), ones.data());
  for (int j = 0; j < problem.columns(); ++j) solver.setInteger(j);
}

int no_callback(CbcModel* /*model*/, int /*where*/) { return 0; }

void run_command_line(CbcModel& model, const Budget& budget) {
  CbcSolverUsefulData data;
  data.noPrinting_ = true;
  CbcMain0(model, data);
  const std::string seconds = std::to_string(budget.seconds_left());
  std::vector<const char*> arguments = {"cbc", "-log", "0", "-ratio", "0"};
  if (budget.deadline != Clock::time_point::max()) {
    arguments.insert(arguments.end(), {"-timeMode", "elapsed", "-seconds", seconds.c_str()});
  }
  arguments.insert(arguments.end(), {"-solve", "-quit"});
  CbcMain1(static_cast<int>(arguments.size()), arguments.data(), model, no_callback, data);
}

/// CBC calls a stop at the deadline finished now and then; only a proof counts.
Outcome outcome_of(const CbcModel& model) {
  if (model.isProvenInfeasible()) return Outcome::kInfeasible;
  return model.isProvenOptimal() ? Outcome::kOptimal : Outcome::kDeadline;
}

}  // namespace

LibraryRun cbc_main(const AssociationProblem& problem, const Budget& budget) {
  LibraryRun run;
  if (budget.expired()) return run;
  if (problem.columns() == 0) {
    run.outcome = problem.shape().has_exactly_once_rows ? Outcome::kInfeasible : Outcome::kOptimal;
    return run;
  }
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const auto start = Clock::now();
  OsiClpSolverInterface solver;
  load(problem, solver);
  CbcModel model(solver);
  run.translate_ms = milliseconds_since(start);
  run_command_line(model, budget);
  run.outcome = outcome_of(model);
  run.nodes = model.getNodeCount();
  run.iterations = model.getIterationCount();
  const double* best = model.bestSolution();
  if (best == nullptr || run.outcome == Outcome::kInfeasible) return run;
  run.objective = model.getObjValue();
  run.x.assign(best, best + problem.columns());
  for (double& value : run.x) value = std::clamp(value, 0.0, 1.0);
  return run;
}

}  // namespace mda
