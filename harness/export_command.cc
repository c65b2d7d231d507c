#include <fmt/format.h>

#include "algorithms/catalog.h"
#include "harness/commands.h"
#include "harness/errors.h"
#include "harness/files.h"
#include "harness/judge.h"
#include "harness/plan.h"
#include "harness/run_cell.h"
#include "harness/window_file.h"
#include "harness/words.h"

namespace mda {
namespace {

/// The one cell that holds the window.
Cell cell_of(const ExportCommand& command, const Sweep& sweep) {
  return {&sweep.scenarios[0], sweep.scan_periods_s[0], command.replicate, command.window_k};
}

/// That cell as a sweep driven by the reference.
Sweep sweep_of(const ExportCommand& command) {
  Sweep sweep;
  sweep.scenarios.push_back({.spec = scenario_named(command.scenario),
                             .windows = {command.window_k},
                             .replicates = command.replicate});
  sweep.scenarios[0].spec.model.rows = command.rows;
  sweep.scan_periods_s = {
      command.scan_period_s.value_or(sweep.scenarios[0].spec.world.scan_period_s)};
  sweep.seed = command.seed;
  sweep.driver = reference_algorithm().name;
  sweep.algorithms = {sweep.driver};
  check(sweep, "");
  const int scans = scenario_of(cell_of(command, sweep)).world.scans;
  if (command.scan < 1 || command.scan > scans) {
    throw InputError(fmt::format("scan {}: it must be 1 to {}", command.scan, scans));
  }
  return sweep;
}

AssociationProblem window_of(const ExportCommand& command, const Sweep& sweep) {
  Worker worker;
  const std::vector<Player>& players = worker.driver(sweep);
  const ScenarioSpec spec = scenario_of(cell_of(command, sweep));
  WindowLoop& windows = worker.windows(spec);
  windows.start(spec, sweep.seed, command.replicate, command.window_k, false);
  while (windows.next() && windows.scan() < command.scan) {
    const AssociationProblem& problem = windows.window().problem;
    const Verdicts verdicts = judge(problem, solve_all(problem, players, terms_of(sweep)));
    const Decision decision = advancing_choice(problem, verdicts, sweep.driver);
    windows.advance(decision);
    if (decision.fell_back) {
      throw std::runtime_error(fmt::format("'{}' did not solve the window of scan {} in {} s",
                                           sweep.driver, windows.scan(), sweep.time_limit_s));
    }
  }
  return windows.window().problem;
}

std::string text_of(const ExportCommand& command, const Sweep& sweep,
                    const AssociationProblem& problem) {
  if (command.format == WindowFormat::kMps) return window_mps(problem);
  if (command.format == WindowFormat::kLp) return window_lp(problem);
  return window_json(problem, {{"scenario", command.scenario},
                               {"scan", command.scan},
                               {"window_k", command.window_k},
                               {"replicate", command.replicate},
                               {"scan_period_s", sweep.scan_periods_s[0]},
                               {"seed", command.seed},
                               {"rows", word_of(kRowRuleWords, command.rows)},
                               {"driver", sweep.driver},
                               {"fingerprint", problem.fingerprint()}});
}

}  // namespace

int export_window(const ExportCommand& command) {
  const Sweep sweep = sweep_of(command);
  const std::string text = text_of(command, sweep, window_of(command, sweep));
  if (command.out.empty()) {
    fmt::print("{}", text);
  } else {
    write_file(command.out, text);
  }
  return kWell;
}

}  // namespace mda
