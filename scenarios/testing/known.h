// Scenarios with known targets, and the right answers to their windows.
#pragma once

#include <functional>
#include <vector>

#include "scenarios/known/known_windows.h"
#include "scenarios/spec.h"

namespace mda::testing {

/// Those of scenario_list() that have known targets.
[[nodiscard]] std::vector<ScenarioSpec> known_scenarios();

/// Storms & Spieksma's groups.
[[nodiscard]] std::vector<ScenarioSpec> storms_groups();

/// The scenario, ended after `scans` scans.
[[nodiscard]] ScenarioSpec cut_short(ScenarioSpec spec, int scans);

/// The sequences of the window that take what the targets are the sources of; of a merged plot, the
/// source of the lowest number takes it and the others miss.
[[nodiscard]] std::vector<Tuple> true_sequences(const KnownTrackWindows& windows);

/// Plays replicate 1 under seed 1 by the truth: calls see(windows, true sequences) for every
/// window.
void play_the_truth(
    const ScenarioSpec& spec, int window_k,
    const std::function<void(const KnownTrackWindows&, const std::vector<Tuple>&)>& see);

}  // namespace mda::testing
