#include "harness/run_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/answer.h"
#include "harness/clocks.h"
#include "harness/window_rows.h"

namespace mda {
namespace {

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

void report_window(const Row& common, const WindowLoop& windows, const Verdicts& verdicts,
                   CellReport& report) {
  Tally& tally = report.tally;
  ++tally.windows;
  if (verdicts.exact_spread) {
    ++tally.compared;
    tally.largest_exact_spread = std::max(tally.largest_exact_spread, *verdicts.exact_spread);
  }
  for (const Attempt& attempt : verdicts.attempts) {
    tally.solve_cpu_ms += attempt.spent_cpu_ms;
    const Row row = attempt_row(common, windows, attempt, verdicts);
    const bool asked = attempt.player->asked;
    if (!attempt.skipped || !asked) append_answer_line(row, attempt, report.answers);
    if (!asked) continue;
    append_row_line(row, report.rows);
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

std::vector<Player> make_players(const Sweep& sweep, const ScenarioPlan& plan) {
  std::vector<Player> players;
  const auto add = [&](std::string_view name, bool asked) {
    const auto plays = [&](const Player& p) { return p.entry->name == name; };
    if (std::any_of(players.begin(), players.end(), plays)) return;
    const CatalogEntry* entry = find_algorithm(name);
    players.push_back({entry, asked, entry->make()});
  };
  for (const std::string& name : algorithms_of(sweep, plan)) add(name, true);
  add(sweep.driver, false);
  add(reference_algorithm().name, false);
  return players;
}

bool need_views(const std::vector<Player>& players) {
  return std::any_of(players.begin(), players.end(),
                     [](const Player& p) { return p.solver->traits().needs_views(); });
}

std::vector<Player>& Worker::players(const Sweep& sweep, const ScenarioPlan& plan) {
  const auto [entry, is_new] = players_.try_emplace(&plan);
  if (is_new) entry->second = make_players(sweep, plan);
  return entry->second;
}

std::vector<Player>& Worker::driver(const Sweep& sweep) {
  if (driver_.empty()) {
    const CatalogEntry* entry = find_algorithm(sweep.driver);
    driver_.push_back({entry, false, entry->make()});
  }
  return driver_;
}

SceneBook& Worker::scene_book() {
  scene_book_.reset();
  return scene_book_;
}

WindowLoop& Worker::windows(const ScenarioSpec& spec) {
  if (spec.known_targets) return known_;
  if (spec.position_targets) return positions_;
  if (spec.three_sensors) return sensors_;
  return forest_;
}

CellReport run_cell(const Cell& cell, const Sweep& sweep, Worker& worker, int workers,
                    const std::atomic<bool>& interrupted) {
  const Stopwatch watch;
  CellReport report;
  const ScenarioSpec spec = scenario_of(cell);
  WindowLoop& windows = worker.windows(spec);
  const std::vector<Player>& all = worker.players(sweep, *cell.plan);
  const std::vector<Player>& driver = worker.driver(sweep);
  SceneBook& book = worker.scene_book();
  windows.start(spec, sweep.seed, cell.replicate, cell.window_k, need_views(all));
  report.tally.simulate_cpu_ms = windows.simulate_cpu_ms();
  while (windows.next()) {
    if (interrupted) return {};
    const AssociationProblem& problem = windows.window().problem;
    const std::vector<Player>& players = is_asked(cell, windows.scan()) ? all : driver;
    const Verdicts verdicts = judge(problem, solve_all(problem, players, terms_of(sweep)));
    report_window(window_row({cell, sweep, workers}, windows), windows, verdicts, report);
    if (records_scene(cell)) book.note(worker.forest(), verdicts);
    const Decision decision = advancing_choice(problem, verdicts, sweep.driver);
    windows.advance(decision);
    report.tally.fallbacks += decision.fell_back ? 1 : 0;
    report.tally.hypotheses_cpu_ms += windows.grow_cpu_ms();
  }
  if (records_scene(cell)) report.scene = book.line(cell, sweep, worker.forest().scene());
  report.tally.cell_cpu_ms = watch.cpu_ms();
  report.tally.cell_wall_ms = watch.wall_ms();
  report.finished = true;
  return report;
}

}  // namespace mda
