#include "algorithms/backends/glpk.h"

#include <glpk.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace mda {
namespace {

struct DeleteModel {
  void operator()(glp_prob* model) const { glp_delete_prob(model); }
};
using Model = std::unique_ptr<glp_prob, DeleteModel>;

/// GLPK counts from 1.
Model translate(const AssociationProblem& problem) {
  Model model(glp_create_prob());
  glp_prob* lp = model.get();
  if (problem.rows() > 0) glp_add_rows(lp, problem.rows());
  for (int r = 0; r < problem.rows(); ++r) {
    glp_set_row_bnds(lp, r + 1, problem.use(r) == RowUse::kExactlyOnce ? GLP_FX : GLP_UP, 1.0, 1.0);
  }
  glp_add_cols(lp, problem.columns());
  std::vector<int> rows;
  std::vector<double> values;
  for (int j = 0; j < problem.columns(); ++j) {
    rows.assign(1, 0);
    for (const int r : problem.rows_of(j)) rows.push_back(r + 1);
    values.assign(rows.size(), 1.0);
    glp_set_obj_coef(lp, j + 1, problem.cost(j));
    glp_set_col_kind(lp, j + 1, GLP_BV);
    glp_set_mat_col(lp, j + 1, static_cast<int>(rows.size()) - 1, rows.data(), values.data());
  }
  return model;
}

int milliseconds_left(const Budget& budget) {
  constexpr double kMost = std::numeric_limits<int>::max();  // GLPK: no limit
  return static_cast<int>(std::clamp(1e3 * budget.seconds_left(), 1.0, kMost));
}

/// Returns false at the deadline.
bool finishes(const char* what, int code) {
  if (code == GLP_ETMLIM) return false;
  if (code != 0) {
    throw std::runtime_error(std::string("GLPK: ") + what + " gave up with code " +
                             std::to_string(code));
  }
  return true;
}

bool solve_relaxation(glp_prob* lp, const Budget& budget) {
  glp_smcp settings;
  glp_init_smcp(&settings);
  settings.msg_lev = GLP_MSG_OFF;
  settings.tm_lim = milliseconds_left(budget);
  return finishes("the simplex method", glp_simplex(lp, &settings));
}

bool search(glp_prob* lp, const Budget& budget, std::int64_t& nodes) {
  glp_iocp settings;
  glp_init_iocp(&settings);
  settings.msg_lev = GLP_MSG_OFF;
  settings.tm_lim = milliseconds_left(budget);
  settings.cb_info = &nodes;
  settings.cb_func = [](glp_tree* tree, void* count) {
    if (glp_ios_reason(tree) == GLP_ISELECT) ++*static_cast<std::int64_t*>(count);
  };
  return finishes("the search", glp_intopt(lp, &settings));
}

}  // namespace

LibraryRun glpk(const AssociationProblem& problem, const Budget& budget) {
  LibraryRun run;
  if (budget.expired()) return run;
  if (problem.columns() == 0) {
    run.outcome = problem.shape().has_exactly_once_rows ? Outcome::kInfeasible : Outcome::kOptimal;
    return run;
  }
  const auto start = Clock::now();
  const Model model = translate(problem);
  glp_prob* lp = model.get();
  run.translate_ms = milliseconds_since(start);
  if (!solve_relaxation(lp, budget)) return run;
  run.iterations = glp_get_it_cnt(lp);
  if (glp_get_status(lp) != GLP_OPT) {
    run.outcome = Outcome::kInfeasible;
    return run;
  }
  const bool finished = search(lp, budget, run.nodes);
  const int status = glp_mip_status(lp);
  if (finished) run.outcome = status == GLP_OPT ? Outcome::kOptimal : Outcome::kInfeasible;
  if (status != GLP_OPT && status != GLP_FEAS) return run;
  run.objective = glp_mip_obj_val(lp);
  for (int j = 0; j < problem.columns(); ++j) {
    run.x.push_back(std::clamp(glp_mip_col_val(lp, j + 1), 0.0, 1.0));
  }
  return run;
}

}  // namespace mda
