#include "scenarios/testing/positions.h"

#include <algorithm>
#include <iterator>

#include "scenarios/groups.h"

namespace mda::testing {

std::vector<ScenarioSpec> position_scenarios() {
  std::vector<ScenarioSpec> found;
  std::ranges::copy_if(scenario_list(), std::back_inserter(found),
                       [](const ScenarioSpec& spec) { return spec.position_targets.has_value(); });
  return found;
}

void play_true_positions(const ScenarioSpec& spec, int replicate,
                         const std::function<void(const PositionWindows&)>& see) {
  PositionWindows windows(spec, 1, replicate);
  while (windows.next()) {
    see(windows);
    windows.advance(windows.true_beliefs());
  }
}

}  // namespace mda::testing
