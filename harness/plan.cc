#include "harness/plan.h"

#include <algorithm>

#include "scenarios/duration.h"

namespace mda {
namespace {

/// Grows with the time that a cell takes, roughly: plots per scan, gates and window width.
double expected_work(const Cell& cell) {
  if (duration_s(cell.plan->spec)) {
    const int players = static_cast<int>(cell.plan->algorithms.size()) + 1;
    return scan_count(scenario_of(cell)) * cell.window_k * players;
  }
  if (cell.plan->spec.three_sensors) return cell.plan->spec.three_sensors->targets;
  const World& world = cell.plan->spec.world;
  const double density =
      (world.births_per_scan * world.births_per_scan + 0.1 * world.clutter_per_scan) /
      world.birth_side_km;
  return density * cell.window_k * cell.scan_period_s;
}

}  // namespace

std::vector<Cell> plan(const Sweep& sweep) {
  std::vector<Cell> cells;
  for (const ScenarioPlan& scenario : sweep.scenarios) {
    for (const double period : scan_periods_of(sweep, scenario)) {
      for (int replicate = scenario.first_replicate; replicate <= scenario.replicates;
           ++replicate) {
        for (const int k : scenario.windows) {
          cells.push_back({&scenario, period, replicate, k});
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
  ScenarioSpec spec = cell.plan->spec;
  spec.world.scan_period_s = cell.scan_period_s;
  if (duration_s(spec)) spec.world.scans = scan_count(spec);
  return spec;
}

}  // namespace mda
