// The linear Kalman filter of a target seen as a position, and its update with several plots at
// once (Bar-Shalom & Fortmann, "Tracking and Data Association", 1988: probabilistic data
// association).
#pragma once

#include <Eigen/Dense>
#include <span>

#include "scenarios/cartesian/motion.h"
#include "scenarios/world/scene.h"

namespace mda {

struct MotionEstimate {
  MotionVector mean = MotionVector::Zero();
  MotionMatrix covariance = MotionMatrix::Zero();
};

/// The estimate right after the second of two plots that are one scan period apart: position of the
/// second, velocity by differencing, acceleration 0. Process noise in between is left out.
[[nodiscard]] MotionEstimate two_plot_estimate(const MotionModel& model, double plot_sigma_km,
                                               double scan_period_s, const Eigen::Vector2d& first,
                                               const Eigen::Vector2d& second);

/// One scan period later.
[[nodiscard]] MotionEstimate predict(const MotionModel& model, const MotionEstimate& estimate);

/// Where a plot is expected, and its distribution around that.
struct PositionInnovation {
  Eigen::Vector2d plot;        ///< km
  Eigen::Matrix2d covariance;  ///< S, km^2
  Eigen::Matrix2d inverse;     ///< of S
  double log_peak = 0.0;       ///< ln N(0; 0, S), per km^2

  /// Squared Mahalanobis distance: chi-square with 2 degrees of freedom.
  [[nodiscard]] double distance(const Eigen::Vector2d& at) const {
    const Eigen::Vector2d nu = at - plot;
    return nu.dot(inverse * nu);
  }
};

/// Throws std::runtime_error if S is not positive definite, or not finite.
[[nodiscard]] PositionInnovation innovation(double plot_sigma_km, const MotionEstimate& predicted);

struct WeightedPlot {
  Eigen::Vector2d position;  ///< km
  double weight = 1.0;       ///< probability that it is the target's, >= 0
};

/// By all `plots` at once; what the weights lack of 1 is the probability that none is the target's.
/// The covariance is the mixture's, the spread of the means included (with weights that add up to
/// more than 1 it stays positive semidefinite, but no mixture has it). No plots leave the estimate
/// alone; one of weight 1 makes it the Kalman update in Joseph's form. O(plots).
[[nodiscard]] MotionEstimate update(const MotionEstimate& predicted,
                                    const PositionInnovation& expected, double plot_sigma_km,
                                    std::span<const WeightedPlot> plots);

[[nodiscard]] TargetState state_of(const MotionEstimate& estimate);

}  // namespace mda
