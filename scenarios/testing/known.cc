#include "scenarios/testing/known.h"

#include <algorithm>
#include <iterator>

#include "scenarios/groups.h"

namespace mda::testing {

std::vector<ScenarioSpec> known_scenarios() {
  std::vector<ScenarioSpec> found;
  std::ranges::copy_if(scenario_list(), std::back_inserter(found),
                       [](const ScenarioSpec& spec) { return spec.known_targets.has_value(); });
  return found;
}

std::vector<ScenarioSpec> storms_groups() {
  std::vector<ScenarioSpec> found;
  for (const char* name : {"A", "B", "C", "D"}) found.push_back(*find_scenario(name));
  return found;
}

ScenarioSpec cut_short(ScenarioSpec spec, int scans) {
  spec.known_targets->duration_s = scans * spec.world.scan_period_s;
  return spec;
}

std::vector<Tuple> true_sequences(const KnownTrackWindows& windows) {
  std::vector<Tuple> tuples;
  for (int track = 0; track < windows.tracks(); ++track) tuples.push_back({track, {}});
  int row = windows.tracks();
  for (int k = 1; k <= windows.window_scans(); ++k) {
    for (Tuple& tuple : tuples) tuple.rows.push_back(kNoRow);
    const int scan = windows.newest_scan() - windows.window_scans() + k;
    for (const DopplerPlot& plot :
         windows.scene().scans[static_cast<std::size_t>(scan) - 1].plots) {
      if (!plot.sources.empty()) {
        tuples[static_cast<std::size_t>(plot.sources.front())].rows.back() = row;
      }
      ++row;
    }
  }
  return tuples;
}

void play_the_truth(
    const ScenarioSpec& spec, int window_k,
    const std::function<void(const KnownTrackWindows&, const std::vector<Tuple>&)>& see) {
  KnownTrackWindows windows(spec, 1, 1, window_k);
  while (windows.next()) {
    const std::vector<Tuple> tuples = true_sequences(windows);
    see(windows, tuples);
    windows.advance(tuples);
  }
}

}  // namespace mda::testing
