#include "scenarios/testing/scenes.h"

#include <algorithm>
#include <cmath>

namespace mda::testing {

double range_of(const TargetState& state) { return std::hypot(state.x, state.y); }

const TruePosition* truth_of(const Scan& scan, int target) {
  const auto found = std::ranges::find(scan.truth, target, &TruePosition::target);
  return found == scan.truth.end() ? nullptr : &*found;
}

const Plot* plot_of(const Scan& scan, int target) {
  const auto found = std::ranges::find(scan.plots, target, &Plot::source);
  return found == scan.plots.end() ? nullptr : &*found;
}

}  // namespace mda::testing
