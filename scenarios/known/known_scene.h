// Monte Carlo scenes of known targets (Battistelli et al. 2008, section IV): the trajectories are
// fixed; noise, missed detections and clutter are drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "scenarios/filter/ekf.h"
#include "scenarios/known/doppler_ekf.h"
#include "scenarios/known/trajectories.h"
#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

struct DopplerPlot {
  double range_km = 0.0;
  double bearing_rad = 0.0;       ///< in (-pi, pi], from the x axis towards the y axis
  double range_rate_km_s = 0.0;   ///< positive when the range grows
  std::vector<int> sources = {};  ///< target numbers, ascending; none: clutter, several: merged.
                                  ///< Known to the metrics only
};

[[nodiscard]] inline DopplerMeasurement measurement_of(const DopplerPlot& plot) {
  return {plot.range_km, plot.bearing_rad, plot.range_rate_km_s};
}

/// One turn of the antenna. Plots are in the order of their range: no order tells of their source.
struct KnownScan {
  std::vector<DopplerPlot> plots;
  std::vector<TargetState> truth;  ///< [target]
  std::vector<DopplerPlot> own;    ///< [target]: its plot with the same noise, before merging, and
                                   ///< whether the target is detected or not
  std::vector<bool> detected;      ///< [target]
};

struct KnownScene {
  std::vector<KnownScan> scans;   ///< [scan - 1]; scan n is taken at n scan periods
  std::vector<Gaussian> initial;  ///< [target]: the given estimate at time 0
  PlotBox clutter_box;
};

/// The scene of one replicate (counted from 1). Depends on (seed, draws_as or else the name,
/// replicate), the world and the known targets. Every target draws the same numbers whether it is
/// detected or not. Plots of one scan that chain up, each nearer to the next than the resolution in
/// range and in bearing, become their mean: clutter too. O(scans x plots^2). Throws
/// std::invalid_argument if the scenario has no known targets.
[[nodiscard]] KnownScene simulate_known(const ScenarioSpec& spec, std::uint64_t seed,
                                        int replicate);

/// What a radar of that resolution makes of plots: in the order of their range.
[[nodiscard]] std::vector<DopplerPlot> resolved(const std::vector<DopplerPlot>& plots,
                                                const KnownTargets& targets);

}  // namespace mda
