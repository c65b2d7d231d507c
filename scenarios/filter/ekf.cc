#include "scenarios/filter/ekf.h"

#include <cmath>
#include <numbers>

#include "scenarios/filter/kalman.h"

namespace mda {
namespace {

constexpr double kLeastRangeKm = 1e-9;
constexpr int kIterations = 6;

/// Range, bearing and the Jacobian of both at a position.
void measure(double x, double y, Eigen::Vector2d& plot, Eigen::Matrix<double, 2, 4>& jacobian) {
  const double r = std::max(std::hypot(x, y), kLeastRangeKm);
  plot << r, std::atan2(y, x);
  jacobian << x / r, 0.0, y / r, 0.0, -y / (r * r), 0.0, x / (r * r), 0.0;
}

Eigen::Matrix2d plot_covariance(const World& world) {
  return Eigen::Vector2d(world.range_sigma_km * world.range_sigma_km,
                         world.bearing_sigma_rad * world.bearing_sigma_rad)
      .asDiagonal();
}

/// Gauss-Newton on the posterior: relinearises the measurement at the last result.
Gaussian iterated_update(const World& world, const Gaussian& predicted, const Plot& plot) {
  Gaussian state = predicted;
  for (int i = 0; i < kIterations; ++i) {
    Innovation at = innovation(world, {state.mean, predicted.covariance});
    const Eigen::Vector2d nu = residual(at, plot) - at.jacobian * (predicted.mean - state.mean);
    state = kalman_update<2>(predicted, nu, at.jacobian, at.covariance.inverse());
  }
  return state;
}

Gaussian converted_update(const World& world, const Gaussian& predicted, const Plot& plot) {
  Eigen::Matrix<double, 2, 4> position = Eigen::Matrix<double, 2, 4>::Zero();
  position(0, 0) = 1.0;
  position(1, 2) = 1.0;
  const Eigen::Matrix2d covariance =
      position * predicted.covariance * position.transpose() + cartesian_covariance(world, plot);
  const Eigen::Vector2d nu = to_cartesian(plot) - position * predicted.mean;
  return kalman_update<2>(predicted, nu, position, covariance.inverse());
}

/// Position of the second plot, velocity by differencing. The velocity's error is that of the two
/// plots and of the accelerations in between.
Gaussian differenced_state(const World& world, const Plot& first, const Plot& second, int scans) {
  const double t = scans * world.scan_period_s;
  const Eigen::Vector2d now = to_cartesian(second);
  const Eigen::Vector2d velocity = (now - to_cartesian(first)) / t;
  const Eigen::Matrix2d r2 = cartesian_covariance(world, second);
  const AxisNoise q = process_noise(world, scans);
  const Eigen::Matrix2d vv = (cartesian_covariance(world, first) + r2) / (t * t) +
                             (q.vv - 2.0 * q.pv / t + q.pp / (t * t)) * Eigen::Matrix2d::Identity();
  Gaussian state;
  state.mean << now.x(), velocity.x(), now.y(), velocity.y();
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      state.covariance(2 * i, 2 * j) = r2(i, j);
      state.covariance(2 * i, 2 * j + 1) = r2(i, j) / t;
      state.covariance(2 * i + 1, 2 * j) = r2(i, j) / t;
      state.covariance(2 * i + 1, 2 * j + 1) = vv(i, j);
    }
  }
  return state;
}

}  // namespace

AxisNoise process_noise(const World& world, int scans) {
  const double t = world.scan_period_s;
  const double variance = world.acceleration_sigma_km_s2 * world.acceleration_sigma_km_s2;
  AxisNoise q;
  for (int i = 0; i < scans; ++i) {
    q.pp += 2.0 * t * q.pv + t * t * q.vv + 0.25 * t * t * t * t * variance;
    q.pv += t * q.vv + 0.5 * t * t * t * variance;
    q.vv += t * t * variance;
  }
  return q;
}

Eigen::Vector2d to_cartesian(const Plot& plot) {
  return {plot.range_km * std::cos(plot.bearing_rad), plot.range_km * std::sin(plot.bearing_rad)};
}

Eigen::Matrix2d cartesian_covariance(const World& world, const Plot& plot) {
  const double c = std::cos(plot.bearing_rad);
  const double s = std::sin(plot.bearing_rad);
  Eigen::Matrix2d jacobian;
  jacobian << c, -plot.range_km * s, s, plot.range_km * c;
  return jacobian * plot_covariance(world) * jacobian.transpose();
}

double velocity_sigma(const World& world, const TrackerModel& model) {
  return model.velocity_prior * world.speed_max_km_s;
}

Gaussian newborn_state(const World& world, const TrackerModel& model, const Plot& plot) {
  const Eigen::Vector2d position = to_cartesian(plot);
  const Eigen::Matrix2d r = cartesian_covariance(world, plot);
  const double sigma = velocity_sigma(world, model);
  Gaussian state;
  state.mean << position.x(), 0.0, position.y(), 0.0;
  state.covariance.setZero();
  state.covariance(0, 0) = r(0, 0);
  state.covariance(0, 2) = r(0, 1);
  state.covariance(2, 0) = r(1, 0);
  state.covariance(2, 2) = r(1, 1);
  state.covariance(1, 1) = sigma * sigma;
  state.covariance(3, 3) = sigma * sigma;
  return state;
}

Gaussian two_plot_state(const World& world, const TrackerModel& model, const Plot& first,
                        const Plot& second, int scans) {
  if (model.second_plot == SecondPlot::kTwoPoint) {
    return differenced_state(world, first, second, scans);
  }
  Gaussian predicted = newborn_state(world, model, first);
  for (int i = 0; i < scans; ++i) predicted = predict(world, predicted);
  switch (model.second_plot) {
    case SecondPlot::kIteratedEkf:
      return iterated_update(world, predicted, second);
    case SecondPlot::kConverted:
      return converted_update(world, predicted, second);
    default:
      return update(predicted, innovation(world, predicted), second);
  }
}

Gaussian predict(const World& world, const Gaussian& state) {
  Eigen::Matrix4d f = Eigen::Matrix4d::Identity();
  f(0, 1) = world.scan_period_s;
  f(2, 3) = world.scan_period_s;
  Gaussian next{f * state.mean, f * state.covariance * f.transpose()};
  const AxisNoise q = process_noise(world, 1);
  for (int axis = 0; axis < 4; axis += 2) {
    next.covariance(axis, axis) += q.pp;
    next.covariance(axis, axis + 1) += q.pv;
    next.covariance(axis + 1, axis) += q.pv;
    next.covariance(axis + 1, axis + 1) += q.vv;
  }
  return next;
}

Innovation innovation(const World& world, const Gaussian& predicted) {
  Innovation expected;
  measure(predicted.mean(0), predicted.mean(2), expected.plot, expected.jacobian);
  expected.covariance = expected.jacobian * predicted.covariance * expected.jacobian.transpose() +
                        plot_covariance(world);
  return expected;
}

Eigen::Vector2d residual(const Innovation& expected, const Plot& plot) {
  return {plot.range_km - expected.plot(0),
          std::remainder(plot.bearing_rad - expected.plot(1), 2.0 * std::numbers::pi)};
}

Gaussian update(const Gaussian& predicted, const Innovation& expected, const Plot& plot) {
  return kalman_update<2>(predicted, residual(expected, plot), expected.jacobian,
                          expected.covariance.inverse());
}

}  // namespace mda
