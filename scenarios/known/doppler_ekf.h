// The extended Kalman filter of a nearly constant velocity target seen in range, bearing and range
// rate (Battistelli et al. 2008, equation IV.1 and before it). State (x, vx, y, vy) in km and km/s;
// predict() and the process noise are those of scenarios/filter/ekf.h.
#pragma once

#include <Eigen/Dense>

#include "scenarios/filter/ekf.h"
#include "scenarios/spec.h"

namespace mda {

/// Range in km, bearing in (-pi, pi], range rate in km/s, positive when the range grows.
using DopplerMeasurement = Eigen::Vector3d;

/// What a radar at the origin would measure of a state, without noise. At a range of 0, where
/// bearing and range rate are undefined, a range of 1e-9 km is taken instead.
[[nodiscard]] DopplerMeasurement measured(const TargetState& state);

/// What a plot is expected to be, and its distribution around that.
struct DopplerInnovation {
  DopplerMeasurement plot;               ///< h of the predicted state
  Eigen::Matrix<double, 3, 4> jacobian;  ///< of h there
  Eigen::Matrix3d covariance;            ///< S
  Eigen::Matrix3d inverse;               ///< of S
  double log_peak = 0.0;                 ///< ln N(0; 0, S), per km rad km/s
};

/// Throws std::invalid_argument if the scenario has no known targets.
[[nodiscard]] Eigen::Matrix3d doppler_plot_covariance(const ScenarioSpec& spec);

/// `plot_covariance`: of the measurement's noise.
[[nodiscard]] DopplerInnovation innovation(const Eigen::Matrix3d& plot_covariance,
                                           const Gaussian& predicted);

/// Plot minus expectation, the bearing's difference in [-pi, pi].
[[nodiscard]] Eigen::Vector3d residual(const DopplerInnovation& expected,
                                       const DopplerMeasurement& plot);

/// Squared Mahalanobis distance of a residual: chi-square with 3 degrees of freedom.
[[nodiscard]] double distance(const DopplerInnovation& expected, const Eigen::Vector3d& residual);

[[nodiscard]] Gaussian update(const Gaussian& predicted, const DopplerInnovation& expected,
                              const DopplerMeasurement& plot);

/// ln N(plot; h, S), per km rad km/s.
[[nodiscard]] double log_likelihood(const DopplerInnovation& expected,
                                    const DopplerMeasurement& plot);

[[nodiscard]] TargetState state_of(const Gaussian& estimate);

}  // namespace mda
