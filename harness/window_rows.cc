#include "harness/window_rows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

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
  if (solution.stats.lp_fractional) {  // an LP over something else than the columns
    row.fractional = solution.stats.lp_fractional;
    row.integral = *row.fractional == 0;
    return;
  }
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

/// Exactly-once rows go on alone, as cheaply as they can. Needs an always feasible problem.
double cost_of_doing_nothing(const AssociationProblem& problem) {
  if (!problem.shape().has_exactly_once_rows) return 0.0;
  std::map<int, double> alone;
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    if (rows.size() != 1 || problem.use(rows[0]) != RowUse::kExactlyOnce) continue;
    const auto [entry, is_new] = alone.emplace(rows[0], problem.cost(j));
    if (!is_new) entry->second = std::min(entry->second, problem.cost(j));
  }
  double cost = 0.0;
  for (const auto& [row, least] : alone) cost += least;
  return cost;
}

void add_gap(const AssociationProblem& problem, const Attempt& attempt, const Verdicts& verdicts,
             Row& row) {
  row.reference_cost_nats = verdicts.reference_cost;
  if (attempt.solution.answer != Answer::kSelection || !attempt.examined.well_formed) return;
  if (!verdicts.reference_cost) return;
  row.gap_nats = attempt.examined.cost - *verdicts.reference_cost;
  if (!problem.shape().always_feasible) return;
  const double most = cost_of_doing_nothing(problem) - *verdicts.reference_cost;
  row.gap_share = most > 0.0 ? *row.gap_nats / most : 0.0;
}

}  // namespace

Row window_row(const RowContext& context, const WindowLoop& windows) {
  const auto& [cell, sweep, workers] = context;
  const WindowInstance& window = windows.window();
  const Shape& shape = window.problem.shape();
  Row row;
  row.scenario = cell.plan->spec.name;
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
  row.views_ms = windows.views_ms();
  row.workers = workers;
  row.of_sensors = cell.plan->spec.three_sensors.has_value();
  return row;
}

Row attempt_row(Row row, const AssociationProblem& problem, const Attempt& attempt,
                const Verdicts& verdicts) {
  const double views_ms = row.views_ms.value_or(0.0);
  row.views_ms.reset();  // charged to those who ask for them
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
  row.off_column_paths = solution.stats.off_column_paths;
  row.graph_nodes = solution.stats.graph_nodes;
  row.graph_arcs = solution.stats.graph_arcs;
  if (attempt.player->solver->traits().needs_views()) {
    row.views_ms = views_ms + solution.stats.graph_ms.value_or(0.0);
  }
  row.bound_nats = solution.lower_bound;
  row.certified_bound_nats = attempt.certified_bound;
  if (attempt.examined.well_formed) {
    row.cost_nats = attempt.examined.cost;
    row.row_violation = attempt.examined.row_violation;
  }
  if (!solution.ranked.empty()) row.ranked_nats = ranked_costs(problem, solution.ranked);
  add_gap(problem, attempt, verdicts, row);
  add_integrality(problem, attempt, verdicts, row);
  return row;
}

Row attempt_row(Row row, const WindowLoop& windows, const Attempt& attempt,
                const Verdicts& verdicts) {
  row = attempt_row(std::move(row), windows.window().problem, attempt, verdicts);
  const Solution& solution = attempt.solution;
  if (!attempt.skipped && solution.answer == Answer::kSelection && attempt.examined.is_choice()) {
    row.association = windows.association(solution);
  }
  return row;
}

}  // namespace mda
