#include "harness/plan.h"

#include <algorithm>

namespace mda {
namespace {

/// Grows with the time that a cell takes, roughly: plots per scan, gates and window width.
double expected_work(const Cell& cell) {
  const World& world = cell.spec->world;
  const double density =
      (world.births_per_scan * world.births_per_scan + 0.1 * world.clutter_per_scan) /
      world.birth_side_km;
  return density * cell.window_k * cell.scan_period_s;
}

}  // namespace

std::vector<Cell> plan(const Sweep& sweep) {
  std::vector<Cell> cells;
  for (const ScenarioPlan& scenario : sweep.scenarios) {
    for (const double period : sweep.scan_periods_s) {
      for (int replicate = 1; replicate <= scenario.replicates; ++replicate) {
        for (const int k : scenario.windows) {
          cells.push_back({&scenario.spec, period, replicate, k});
        }
      }
    }
  }
  std::stable_sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return expected_work(a) > expected_work(b);
  });
  return cells;
}

ScenarioSpec scenario_of(const Cell& cell) {
  ScenarioSpec spec = *cell.spec;
  spec.world.scan_period_s = cell.scan_period_s;
  return spec;
}

}  // namespace mda
