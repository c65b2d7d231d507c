#include "scenarios/hypotheses/cost.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mda {

using std::numbers::pi;

CostTerms cost_terms(const World& world, const TrackerModel& model) {
  CostTerms terms;
  terms.birth = std::log(world.clutter_per_scan / world.births_per_scan);
  terms.detection =
      std::log(world.clutter_per_scan / world.detection_probability) + std::log(2.0 * pi);
  terms.miss = -std::log(1.0 - world.detection_probability);
  const double all = terms.miss * (model.max_misses + 1);
  switch (model.trailing_misses) {
    case TrailingMisses::kAll:
      break;
    case TrailingMisses::kAllowed:
      terms.ended_discount = terms.miss;
      break;
    case TrailingMisses::kLiveOnly:
      terms.ended_discount = all;
      break;
    case TrailingMisses::kNone:
      terms.ended_discount = all;
      terms.live_discount = terms.miss;
      break;
  }
  return terms;
}

double log_clutter_density(const World& world, const TrackerModel& model, const Plot& plot) {
  const double log_area = std::log(pi * world.range_km * world.range_km);
  switch (model.density) {
    case Density::kLiteral:
      return -log_area;
    case Density::kJacobian:
      return std::log(std::max(plot.range_km, 1e-9)) - log_area;
    case Density::kPolarUniform:
      return -std::log(2.0 * pi * world.range_km);
  }
  return 0.0;
}

}  // namespace mda
