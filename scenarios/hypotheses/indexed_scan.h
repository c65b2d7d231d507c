// The plots of one scan, laid out for gating: sorted by range, with a table from range to plot.
#pragma once

#include <vector>

#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

/// A plot's position and its covariance in Cartesian coordinates (km, km^2).
struct CartesianPlot {
  double x, y;
  double xx, xy, yy;
};

class IndexedScan {
 public:
  /// `scan.plots` must be in the order of their range. Keeps the memory of what was there before.
  void assign(const World& world, const TrackerModel& model, const Scan& scan);

  [[nodiscard]] int size() const noexcept { return static_cast<int>(range.size()); }

  /// First plot of a bucket; buckets are 1 / buckets_per_km wide, and there is one past the last.
  [[nodiscard]] int first_in(int bucket) const { return first_[static_cast<std::size_t>(bucket)]; }

  // One entry per plot.
  std::vector<double> range;
  std::vector<double> bearing;
  std::vector<double> log_density;  ///< ln f_phi
  std::vector<CartesianPlot> cartesian;

  double buckets_per_km = 1.0;
  double last_bucket = 0.0;  ///< the one past all plots, as the number that the kernel needs

 private:
  std::vector<int> first_;
};

}  // namespace mda
