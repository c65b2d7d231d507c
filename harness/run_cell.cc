#include "harness/run_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/clocks.h"
#include "harness/row.h"

namespace mda {
namespace {

/// The fields that all rows of a window share.
Row window_row(const Cell& cell, const Sweep& sweep, const WindowLoop& windows, int workers) {
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

void count(const Row& row, const Attempt& attempt, Tally& tally) {
  ++tally.rows;
  if (attempt.skipped) {
    ++tally.skipped;
  } else if (attempt.refuted) {
    ++tally.refuted;
  } else if (attempt.solution.status == Status::kFailed) {
    ++tally.failed;
  } else if (attempt.solution.stop == Stop::kDeadline) {
    ++tally.timed_out;
  }
  if (attempt.solution.status != Status::kFailed || !tally.worst_example.empty()) return;
  tally.worst_example =
      fmt::format("{} on {} replicate {}, T = {} s, K = {}, scan {}: {}", row.algorithm,
                  row.scenario, row.replicate, row.scan_period_s, row.window_k, row.scan, row.note);
}

void report_window(const Row& common, const AssociationProblem& problem, const Verdicts& verdicts,
                   CellReport& report) {
  Tally& tally = report.tally;
  ++tally.windows;
  if (verdicts.exact_spread) {
    ++tally.compared;
    tally.largest_exact_spread = std::max(tally.largest_exact_spread, *verdicts.exact_spread);
  }
  for (const Attempt& attempt : verdicts.attempts) {
    tally.solve_cpu_ms += attempt.cpu_ms;
    if (!attempt.player->asked) continue;
    const Row row = attempt_row(common, problem, attempt, verdicts);
    append_row_line(row, report.rows);
    if (!attempt.skipped) append_answer_line(row, attempt.solution, report.answers);
    count(row, attempt, tally);
  }
}

}  // namespace

void Tally::add(const Tally& other) {
  windows += other.windows;
  rows += other.rows;
  failed += other.failed;
  refuted += other.refuted;
  skipped += other.skipped;
  timed_out += other.timed_out;
  fallbacks += other.fallbacks;
  compared += other.compared;
  largest_exact_spread = std::max(largest_exact_spread, other.largest_exact_spread);
  if (worst_example.empty()) worst_example = other.worst_example;
  simulate_cpu_ms += other.simulate_cpu_ms;
  hypotheses_cpu_ms += other.hypotheses_cpu_ms;
  solve_cpu_ms += other.solve_cpu_ms;
  cell_cpu_ms += other.cell_cpu_ms;
  cell_wall_ms += other.cell_wall_ms;
}

std::vector<Player> make_players(const Sweep& sweep) {
  std::vector<Player> players;
  const auto add = [&](std::string_view name, bool asked) {
    const auto plays = [&](const Player& p) { return p.entry->name == name; };
    if (std::any_of(players.begin(), players.end(), plays)) return;
    const CatalogEntry* entry = find_algorithm(name);
    players.push_back({entry, asked, entry->make()});
  };
  for (const std::string& name : sweep.algorithms) add(name, true);
  add(sweep.driver, false);
  add(reference_algorithm().name, false);
  return players;
}

CellReport run_cell(const Cell& cell, const Sweep& sweep, Worker& worker, int workers,
                    const std::atomic<bool>& interrupted) {
  const Stopwatch watch;
  CellReport report;
  WindowLoop& windows = worker.windows;
  windows.start(scenario_of(cell), sweep.seed, cell.replicate, cell.window_k);
  report.tally.simulate_cpu_ms = windows.simulate_cpu_ms();
  while (windows.next()) {
    if (interrupted) return {};
    const AssociationProblem& problem = windows.window().problem;
    const Verdicts verdicts =
        judge(problem, solve_all(problem, worker.players, sweep.time_limit_s, sweep.seed));
    report_window(window_row(cell, sweep, windows, workers), problem, verdicts, report);
    bool fell_back = false;
    windows.advance(advancing_choice(problem, verdicts, sweep.driver, fell_back));
    report.tally.fallbacks += fell_back ? 1 : 0;
    report.tally.hypotheses_cpu_ms += windows.grow_cpu_ms();
  }
  report.tally.cell_cpu_ms = watch.cpu_ms();
  report.tally.cell_wall_ms = watch.wall_ms();
  report.finished = true;
  return report;
}

}  // namespace mda
