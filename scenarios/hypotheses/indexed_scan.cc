#include "scenarios/hypotheses/indexed_scan.h"

#include <algorithm>

#include "scenarios/filter/ekf.h"
#include "scenarios/hypotheses/cost.h"

namespace mda {

void IndexedScan::assign(const World& world, const TrackerModel& model, const Scan& scan) {
  const std::size_t n = scan.plots.size();
  range.resize(n);
  bearing.resize(n);
  log_density.resize(n);
  cartesian.resize(n);
  for (std::size_t j = 0; j < n; ++j) {
    const Plot& plot = scan.plots[j];
    range[j] = plot.range_km;
    bearing[j] = plot.bearing_rad;
    log_density[j] = log_clutter_density(world, model, plot);
    const Eigen::Vector2d position = to_cartesian(plot);
    const Eigen::Matrix2d covariance = cartesian_covariance(world, plot);
    cartesian[j] = {position.x(), position.y(), covariance(0, 0), covariance(0, 1),
                    covariance(1, 1)};
  }
  // Four buckets a plot: a gate then starts within a plot or so of its first candidate.
  const int buckets = 4 * static_cast<int>(n) + 1;
  const double longest = n == 0 ? world.range_km : std::max(range.back(), 1e-6);
  buckets_per_km = buckets / longest;
  first_.assign(static_cast<std::size_t>(buckets) + 2, static_cast<int>(n));
  std::size_t j = 0;
  for (int b = 0; b <= buckets; ++b) {
    while (j < n && static_cast<int>(range[j] * buckets_per_km) < b) ++j;
    first_[static_cast<std::size_t>(b)] = static_cast<int>(j);
  }
  last_bucket = buckets + 1;
}

}  // namespace mda
