#include "harness/window_rows.h"

#include <cmath>

namespace mda {
namespace {

/// Integrality of the LP point that an answer is, or was made from.
void add_integrality(const AssociationProblem& problem, const Attempt& attempt,
                     const Verdicts& verdicts, Row& row) {
  if (problem.columns() == 0) {
    row.integral = true;
    row.tight = true;
    row.fractional = 0;
    row.paper_fractional = 0;
    return;
  }
  const Solution& solution = attempt.solution;
  const bool itself = solution.answer == Answer::kRelaxation;
  const Examination lp = itself ? attempt.examined : examine(problem, solution.relaxation);
  if (!lp.well_formed) return;
  row.integral = lp.fractional == 0;
  row.fractional = lp.fractional;
  row.paper_fractional = lp.paper_fractional;
  if (!verdicts.reference_proven) return;
  row.tight =
      std::abs(lp.cost - *verdicts.reference_cost) <= cost_tolerance(*verdicts.reference_cost);
}

void add_gap(const AssociationProblem& problem, const Attempt& attempt, const Verdicts& verdicts,
             Row& row) {
  row.reference_cost_nats = verdicts.reference_cost;
  if (attempt.solution.answer != Answer::kSelection || !attempt.examined.well_formed) return;
  if (!verdicts.reference_cost) return;
  row.gap_nats = attempt.examined.cost - *verdicts.reference_cost;
  if (!problem.shape().always_feasible) return;
  const double doing_nothing = 0.0 - *verdicts.reference_cost;
  row.gap_share = doing_nothing > 0.0 ? *row.gap_nats / doing_nothing : 0.0;
}

}  // namespace

Row window_row(const RowContext& context, const WindowLoop& windows) {
  const auto& [cell, sweep, workers] = context;
  const WindowInstance& window = windows.window();
  const Shape& shape = window.problem.shape();
  Row row;
  row.scenario = cell.spec->name;
  row.driver = sweep.driver;
  row.fingerprint = window.problem.fingerprint();
  row.seed = sweep.seed;
  row.scan_period_s = cell.scan_period_s;
  row.replicate = cell.replicate;
  row.window_k = cell.window_k;
  row.scan = windows.scan();
  row.rows = shape.rows;
  row.columns = shape.columns;
  row.nonzeros = shape.nonzeros;
  row.dimensions = shape.dimensions;
  row.components = shape.components;
  row.largest_component_columns = shape.largest_component_columns;
  row.ungated_columns = window.ungated_columns;
  row.grow_ms = windows.grow_ms();
  row.retired_nats = window.retired_nats;
  row.truth_cost_nats = windows.truth_cost();
  row.workers = workers;
  return row;
}

Row attempt_row(Row row, const AssociationProblem& problem, const Attempt& attempt,
                const Verdicts& verdicts) {
  const Solution& solution = attempt.solution;
  row.algorithm = attempt.player->entry->name;
  row.answer = word(attempt.skipped ? attempt.player->solver->traits().answer : solution.answer);
  row.status = attempt.skipped ? "skipped" : word(solution.status);
  row.stop = word(solution.stop);
  row.note = attempt.note;
  row.reference_cost_nats = verdicts.reference_cost;
  if (attempt.skipped) return row;
  row.wall_ms = attempt.wall_ms;
  row.cpu_ms = attempt.cpu_ms;
  row.translate_ms = solution.stats.translate_ms;
  row.lp_ms = solution.stats.lp_ms;
  row.round_ms = solution.stats.round_ms;
  row.iterations = solution.stats.iterations;
  row.nodes = solution.stats.nodes;
  row.bound_nats = solution.lower_bound;
  row.certified_bound_nats = attempt.certified_bound;
  if (attempt.examined.well_formed) {
    row.cost_nats = attempt.examined.cost;
    row.row_violation = attempt.examined.row_violation;
  }
  add_gap(problem, attempt, verdicts, row);
  add_integrality(problem, attempt, verdicts, row);
  return row;
}

}  // namespace mda
