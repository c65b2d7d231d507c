#include "scenarios/known/doppler_ekf.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "scenarios/filter/kalman.h"

namespace mda {
namespace {

constexpr double kLeastRangeKm = 1e-9;

}  // namespace

DopplerMeasurement measured(const TargetState& s) {
  const double r = std::max(std::hypot(s.x, s.y), kLeastRangeKm);
  return {r, std::atan2(s.y, s.x), (s.x * s.vx + s.y * s.vy) / r};
}

Eigen::Matrix3d doppler_plot_covariance(const ScenarioSpec& spec) {
  if (!spec.known_targets) throw std::invalid_argument(spec.name + " has no known targets");
  const Eigen::Array3d sigmas(spec.world.range_sigma_km, spec.world.bearing_sigma_rad,
                              spec.known_targets->range_rate_sigma_km_s);
  return sigmas.square().matrix().asDiagonal();
}

DopplerInnovation innovation(const Eigen::Matrix3d& plot_covariance, const Gaussian& predicted) {
  const TargetState s = state_of(predicted);
  DopplerInnovation expected;
  expected.plot = measured(s);
  const double r = expected.plot(0);
  const double rate = expected.plot(2);
  const double ux = s.x / r;
  const double uy = s.y / r;
  expected.jacobian << ux, 0.0, uy, 0.0,  //
      -uy / r, 0.0, ux / r, 0.0,          //
      (s.vx - ux * rate) / r, ux, (s.vy - uy * rate) / r, uy;
  expected.covariance =
      expected.jacobian * predicted.covariance * expected.jacobian.transpose() + plot_covariance;
  expected.inverse = expected.covariance.inverse();
  expected.log_peak =
      -0.5 * (3.0 * std::log(2.0 * std::numbers::pi) + std::log(expected.covariance.determinant()));
  return expected;
}

Eigen::Vector3d residual(const DopplerInnovation& expected, const DopplerMeasurement& plot) {
  Eigen::Vector3d nu = plot - expected.plot;
  nu(1) = std::remainder(nu(1), 2.0 * std::numbers::pi);
  return nu;
}

double distance(const DopplerInnovation& expected, const Eigen::Vector3d& residual) {
  return residual.dot(expected.inverse * residual);
}

Gaussian update(const Gaussian& predicted, const DopplerInnovation& expected,
                const DopplerMeasurement& plot) {
  return kalman_update<3>(predicted, residual(expected, plot), expected.jacobian, expected.inverse);
}

double log_likelihood(const DopplerInnovation& expected, const DopplerMeasurement& plot) {
  return expected.log_peak - 0.5 * distance(expected, residual(expected, plot));
}

TargetState state_of(const Gaussian& estimate) {
  return {estimate.mean(0), estimate.mean(1), estimate.mean(2), estimate.mean(3)};
}

}  // namespace mda
