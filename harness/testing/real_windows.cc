#include "harness/testing/real_windows.h"

#include "harness/plan.h"
#include "harness/run_cell.h"

namespace mda::testing {

std::vector<AssociationProblem> real_windows(const WindowSource& source, int step) {
  Sweep sweep;
  sweep.driver = reference_algorithm().name;
  Worker worker;
  const ScenarioPlan plan{.spec = scenario_named(source.scenario), .windows = {source.window_k}};
  const Cell cell{&plan, source.scan_period_s, source.replicate, source.window_k};
  const ScenarioSpec spec = scenario_of(cell);
  std::vector<AssociationProblem> problems;
  WindowLoop& windows = worker.windows(spec);
  windows.start(spec, sweep.seed, cell.replicate, cell.window_k, source.views);
  while (windows.next()) {
    const AssociationProblem& problem = windows.window().problem;
    if (windows.scan() % step == 0 && problem.columns() > 0) problems.push_back(problem);
    const Verdicts verdicts =
        judge(problem, solve_all(problem, worker.driver(sweep), terms_of(sweep)));
    windows.advance(advancing_choice(problem, verdicts, sweep.driver));
  }
  return problems;
}

}  // namespace mda::testing
