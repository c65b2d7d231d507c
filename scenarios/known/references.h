// What association errors are measured against (Battistelli et al. 2008, section IV).
#pragma once

#include <span>
#include <vector>

#include "scenarios/known/known_scene.h"
#include "scenarios/spec.h"

namespace mda {

/// [scan - 1][target].
using StateHistory = std::vector<std::vector<TargetState>>;

/// The ideal case: every target is detected in every scan (P_d = 1), resolved, and filtered with
/// its own plot, from the initial estimates of the scene. O(scans x targets).
[[nodiscard]] StateHistory ideal_states(const KnownScene& scene, const ScenarioSpec& spec);

/// The best that association can do with the real plots: every target takes the plot that it is a
/// source of, a merged one together with others, and a miss if there is none.
[[nodiscard]] StateHistory oracle_states(const KnownScene& scene, const ScenarioSpec& spec);

/// L_n of section IV: whether a track's decision is right. `plots`: [target], the plot of the scan
/// that its track takes, or kNoPlot. Right is a plot that the target is a source of; a miss if the
/// target is not detected; and a miss if its plot is merged and taken by another of its sources,
/// since no two tracks may share a plot.
[[nodiscard]] bool is_right(const KnownScan& scan, std::span<const int> plots, int target);

}  // namespace mda
