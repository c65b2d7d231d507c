// Plots and states for tests of the filter, the same on every machine.
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <cstdint>

#include "scenarios/filter/ekf.h"
#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda::testing {

[[nodiscard]] Plot plot_at(double range_km, double bearing_rad);

/// The transition of straight motion over t seconds, also backwards.
[[nodiscard]] Eigen::Matrix4d transition(double t);

/// The process noise of a state, from that of an axis.
[[nodiscard]] Eigen::Matrix4d noise_of_both_axes(const AxisNoise& axis);

class RandomStates {
 public:
  explicit RandomStates(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] double between(double low, double high);

  /// 1 to n.
  [[nodiscard]] int count(int n);

  /// Somewhere from 2 to 50 km from the radar.
  [[nodiscard]] Plot plot();

  /// Where a target of at most 0.7 km/s seen at `plot` may be seen `scans` periods later.
  [[nodiscard]] Plot later_plot(const World& world, const Plot& plot, int scans);

  /// What a track of two plots predicts for its next scan.
  [[nodiscard]] Gaussian prediction(const World& world);

  /// A well-conditioned covariance whose axes are of very different scales.
  [[nodiscard]] Eigen::Matrix4d covariance();

 private:
  boost::random::mt19937_64 engine_;
};

}  // namespace mda::testing
