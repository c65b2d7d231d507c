#include "scenarios/cartesian/position_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace mda {
namespace {

constexpr int kX = 0;
constexpr int kY = 3;

using PositionGain = Eigen::Matrix<double, 6, 2>;

Eigen::Vector2d position_of(const MotionEstimate& estimate) {
  return {estimate.mean(kX), estimate.mean(kY)};
}

/// P H^T.
PositionGain position_columns(const MotionMatrix& covariance) {
  PositionGain columns;
  columns << covariance.col(kX), covariance.col(kY);
  return columns;
}

/// (1 - K H) P (1 - K H)^T + K R K^T.
MotionMatrix joseph(const MotionMatrix& covariance, const PositionGain& gain,
                    double plot_variance) {
  MotionMatrix rest = MotionMatrix::Identity();
  rest.col(kX) -= gain.col(0);
  rest.col(kY) -= gain.col(1);
  return rest * covariance * rest.transpose() + plot_variance * gain * gain.transpose();
}

}  // namespace

MotionEstimate two_plot_estimate(const MotionModel& model, double plot_sigma_km,
                                 double scan_period_s, const Eigen::Vector2d& first,
                                 const Eigen::Vector2d& second) {
  const double t = scan_period_s;
  const double r = plot_sigma_km * plot_sigma_km;
  const Eigen::Vector2d velocity = (second - first) / t;
  MotionEstimate estimate;
  estimate.mean << second.x(), velocity.x(), 0.0, second.y(), velocity.y(), 0.0;
  Eigen::Matrix3d axis;
  axis << r, r / t, 0.0, r / t, 2.0 * r / (t * t), 0.0, 0.0, 0.0, model.acceleration_variance;
  estimate.covariance.topLeftCorner<3, 3>() = axis;
  estimate.covariance.bottomRightCorner<3, 3>() = axis;
  return estimate;
}

MotionEstimate predict(const MotionModel& model, const MotionEstimate& estimate) {
  const MotionMatrix moved =
      model.transition * estimate.covariance * model.transition.transpose() + model.noise;
  return {model.transition * estimate.mean, 0.5 * (moved + moved.transpose())};
}

PositionInnovation innovation(double plot_sigma_km, const MotionEstimate& predicted) {
  const MotionMatrix& p = predicted.covariance;
  PositionInnovation expected;
  expected.plot = position_of(predicted);
  expected.covariance << p(kX, kX), p(kX, kY), p(kY, kX), p(kY, kY);
  expected.covariance += plot_sigma_km * plot_sigma_km * Eigen::Matrix2d::Identity();
  const double determinant = expected.covariance.determinant();
  const bool sound = determinant > 0.0 && std::isfinite(determinant) &&
                     expected.covariance(0, 0) > 0.0 && predicted.mean.allFinite();
  if (!sound) throw std::runtime_error("the covariance of a track's innovation is singular");
  expected.inverse = expected.covariance.inverse();
  expected.log_peak = -std::log(2.0 * std::numbers::pi) - 0.5 * std::log(determinant);
  return expected;
}

MotionEstimate update(const MotionEstimate& predicted, const PositionInnovation& expected,
                      double plot_sigma_km, std::span<const WeightedPlot> plots) {
  if (plots.empty()) return predicted;
  const PositionGain gain = position_columns(predicted.covariance) * expected.inverse;
  double total = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const WeightedPlot& plot : plots) {
    total += plot.weight;
    mean += plot.weight * (plot.position - expected.plot);
  }
  const double none = std::max(0.0, 1.0 - total);
  Eigen::Matrix2d spread = none * mean * mean.transpose();
  for (const WeightedPlot& plot : plots) {
    const Eigen::Vector2d off = plot.position - expected.plot - mean;
    spread += plot.weight * off * off.transpose();
  }
  const MotionMatrix updated =
      none * predicted.covariance +
      (1.0 - none) * joseph(predicted.covariance, gain, plot_sigma_km * plot_sigma_km) +
      gain * spread * gain.transpose();
  return {predicted.mean + gain * mean, 0.5 * (updated + updated.transpose())};
}

TargetState state_of(const MotionEstimate& estimate) {
  const MotionVector& m = estimate.mean;
  return {m(kX), m(kX + 1), m(kY), m(kY + 1)};
}

}  // namespace mda
