#include "scenarios/known/references.h"

#include <algorithm>

#include "scenarios/hypotheses/track_forest.h"

namespace mda {
namespace {

bool is_source(const DopplerPlot& plot, int target) {
  return std::ranges::binary_search(plot.sources, target);
}

/// Filters all targets; `plot_of(scan, target)`: its plot there, nullptr for a miss.
template <typename PlotOf>
StateHistory filtered(const KnownScene& scene, const ScenarioSpec& spec, PlotOf plot_of) {
  const Eigen::Matrix3d plot_covariance = doppler_plot_covariance(spec);
  std::vector<Gaussian> states = scene.initial;
  StateHistory history;
  for (const KnownScan& scan : scene.scans) {
    history.emplace_back();
    for (std::size_t target = 0; target < states.size(); ++target) {
      Gaussian& state = states[target];
      state = predict(spec.world, state);
      if (const DopplerPlot* plot = plot_of(scan, target)) {
        state = update(state, innovation(plot_covariance, state), measurement_of(*plot));
      }
      history.back().push_back(state_of(state));
    }
  }
  return history;
}

/// The plot that a target is a source of, kNoPlot if there is none.
int plot_of(const KnownScan& scan, int target) {
  const auto found = std::ranges::find_if(
      scan.plots, [&](const DopplerPlot& plot) { return is_source(plot, target); });
  return found == scan.plots.end() ? kNoPlot : static_cast<int>(found - scan.plots.begin());
}

}  // namespace

StateHistory ideal_states(const KnownScene& scene, const ScenarioSpec& spec) {
  return filtered(scene, spec,
                  [](const KnownScan& scan, std::size_t target) { return &scan.own[target]; });
}

StateHistory oracle_states(const KnownScene& scene, const ScenarioSpec& spec) {
  return filtered(scene, spec, [](const KnownScan& scan, std::size_t target) {
    const int plot = plot_of(scan, static_cast<int>(target));
    return plot == kNoPlot ? nullptr : &scan.plots[static_cast<std::size_t>(plot)];
  });
}

bool is_right(const KnownScan& scan, std::span<const int> plots, int target) {
  const int taken = plots[static_cast<std::size_t>(target)];
  if (taken != kNoPlot) return is_source(scan.plots[static_cast<std::size_t>(taken)], target);
  const int own = plot_of(scan, target);
  if (own == kNoPlot) return true;
  const auto& sources = scan.plots[static_cast<std::size_t>(own)].sources;
  return std::ranges::any_of(
      sources, [&](int other) { return plots[static_cast<std::size_t>(other)] == own; });
}

}  // namespace mda
