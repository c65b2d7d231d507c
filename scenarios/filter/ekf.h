// The extended Kalman filter of a nearly constant velocity target seen in range and bearing.
// State (x, vx, y, vy) in km and km/s; plots (range, bearing) in km and rad. Plain textbook form:
// scenarios/hypotheses/lanes.h does the same arithmetic for many tracks at once.
#pragma once

#include <Eigen/Dense>

#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

struct Gaussian {
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
};

/// Process noise of one axis over some scan periods: of position, both, and velocity.
struct AxisNoise {
  double pp = 0.0;
  double pv = 0.0;
  double vv = 0.0;
};

/// The noise added over `scans` >= 0 scan periods, an acceleration being drawn for each.
[[nodiscard]] AxisNoise process_noise(const World& world, int scans);

/// What a plot is expected to be, and its distribution around that.
struct Innovation {
  Eigen::Vector2d plot;                  ///< h(s): range, bearing
  Eigen::Matrix<double, 2, 4> jacobian;  ///< of h at the predicted state
  Eigen::Matrix2d covariance;            ///< B
};

[[nodiscard]] Eigen::Vector2d to_cartesian(const Plot& plot);

/// Covariance of to_cartesian(plot), to first order.
[[nodiscard]] Eigen::Matrix2d cartesian_covariance(const World& world, const Plot& plot);

/// Standard deviation of each velocity component of a newborn, km/s.
[[nodiscard]] double velocity_sigma(const World& world, const TrackerModel& model);

/// The state of a track that has one plot: there, with velocity 0 give or take velocity_sigma.
[[nodiscard]] Gaussian newborn_state(const World& world, const TrackerModel& model,
                                     const Plot& plot);

/// The state of a track that has two plots, `scans` >= 1 scan periods apart, right after the
/// second, as model.second_plot says.
[[nodiscard]] Gaussian two_plot_state(const World& world, const TrackerModel& model,
                                      const Plot& first, const Plot& second, int scans);

/// One scan period later.
[[nodiscard]] Gaussian predict(const World& world, const Gaussian& state);

/// At a range of 0 the bearing is undefined: a range of 1e-9 km is taken instead.
[[nodiscard]] Innovation innovation(const World& world, const Gaussian& predicted);

/// Plot minus expectation, the bearing's difference in [-pi, pi].
[[nodiscard]] Eigen::Vector2d residual(const Innovation& expected, const Plot& plot);

[[nodiscard]] Gaussian update(const Gaussian& predicted, const Innovation& expected,
                              const Plot& plot);

}  // namespace mda
