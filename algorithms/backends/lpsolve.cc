#include "algorithms/backends/lpsolve.h"

#include <lpsolve/lp_lib.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

namespace mda {
namespace {

struct DeleteModel {
  void operator()(lprec* model) const { delete_lp(model); }
};
using Model = std::unique_ptr<lprec, DeleteModel>;

int past_deadline(lprec* /*model*/, void* budget) {
  return static_cast<const Budget*>(budget)->expired() ? TRUE : FALSE;
}

Model translate(const AssociationProblem& problem, bool integer) {
  Model model(make_lp(problem.rows(), 0));
  if (model == nullptr) throw std::runtime_error("lp_solve: no memory");
  lprec* lp = model.get();
  set_verbose(lp, NEUTRAL);
  resize_lp(lp, problem.rows(), problem.columns());
  for (int r = 0; r < problem.rows(); ++r) {
    set_constr_type(lp, r + 1, problem.use(r) == RowUse::kExactlyOnce ? EQ : LE);
    set_rh(lp, r + 1, 1.0);
  }
  std::vector<double> values;
  std::vector<int> rows;
  for (int j = 0; j < problem.columns(); ++j) {
    values.assign(1, problem.cost(j));  // row 0 is the objective
    rows.assign(1, 0);
    for (const int r : problem.rows_of(j)) {
      values.push_back(1.0);
      rows.push_back(r + 1);
    }
    add_columnex(lp, static_cast<int>(rows.size()), values.data(), rows.data());
    if (!integer) continue;  // the rows imply x <= 1
    set_int(lp, j + 1, TRUE);
    set_upbo(lp, j + 1, 1.0);
  }
  return model;
}

}  // namespace

LibraryRun lpsolve(const AssociationProblem& problem, bool integer, const Budget& budget) {
  LibraryRun result;
  if (budget.expired()) return result;
  if (problem.columns() == 0) {
    result.outcome =
        problem.shape().has_exactly_once_rows ? Outcome::kInfeasible : Outcome::kOptimal;
    return result;
  }
  const auto start = Clock::now();
  const Model model = translate(problem, integer);
  lprec* lp = model.get();
  result.translate_ms = milliseconds_since(start);
  Budget own = budget;
  put_abortfunc(lp, past_deadline, &own);
  set_mip_gap(lp, TRUE, 0.0);
  set_mip_gap(lp, FALSE, 0.0);
  set_bb_depthlimit(lp, 0);

  const int status = ::solve(lp);
  result.nodes = get_total_nodes(lp);
  result.iterations = get_total_iter(lp);
  switch (status) {
    case OPTIMAL:
    case PRESOLVED:
      result.outcome = Outcome::kOptimal;
      break;
    case SUBOPTIMAL:
      break;
    case INFEASIBLE:
      result.outcome = Outcome::kInfeasible;
      return result;
    case USERABORT:
    case TIMEOUT:
      return result;
    default:
      throw std::runtime_error("lp_solve gave up with status " + std::to_string(status));
  }
  result.x.resize(problem.costs().size());
  get_variables(lp, result.x.data());
  for (double& value : result.x) value = std::clamp(value, 0.0, 1.0);
  result.objective = get_objective(lp);
  return result;
}

}  // namespace mda
