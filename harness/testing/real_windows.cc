#include "harness/testing/real_windows.h"

#include "harness/plan.h"
#include "harness/run_cell.h"

namespace mda::testing {

std::vector<AssociationProblem> real_windows(const WindowSource& source, int step) {
  Sweep sweep;
  sweep.driver = reference_algorithm().name;
  const std::vector<Player> players = make_players(sweep);
  const ScenarioSpec& spec = scenario_named(source.scenario);
  const Cell cell{&spec, source.scan_period_s, source.replicate, source.window_k};
  std::vector<AssociationProblem> problems;
  WindowLoop windows;
  windows.start(scenario_of(cell), sweep.seed, cell.replicate, cell.window_k);
  while (windows.next()) {
    const AssociationProblem& problem = windows.window().problem;
    if (windows.scan() % step == 0 && problem.columns() > 0) problems.push_back(problem);
    const Verdicts verdicts =
        judge(problem, solve_all(problem, players, sweep.time_limit_s, sweep.seed));
    bool fell_back = false;
    windows.advance(advancing_choice(problem, verdicts, sweep.driver, fell_back));
  }
  return problems;
}

}  // namespace mda::testing
