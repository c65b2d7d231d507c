#include "scenarios/testing/random_states.h"

#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <numbers>

namespace mda::testing {

Plot plot_at(double range_km, double bearing_rad) { return {range_km, bearing_rad, kFalseAlarm}; }

Eigen::Matrix4d transition(double t) {
  Eigen::Matrix4d f = Eigen::Matrix4d::Identity();
  f(0, 1) = f(2, 3) = t;
  return f;
}

Eigen::Matrix4d noise_of_both_axes(const AxisNoise& axis) {
  Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 4; i += 2) {
    noise(i, i) = axis.pp;
    noise(i, i + 1) = noise(i + 1, i) = axis.pv;
    noise(i + 1, i + 1) = axis.vv;
  }
  return noise;
}

double RandomStates::between(double low, double high) {
  return low + (high - low) * boost::random::uniform_01<double>()(engine_);
}

int RandomStates::count(int n) { return static_cast<int>(between(1.0, n + 1.0)); }

Plot RandomStates::plot() {
  return plot_at(between(2.0, 50.0), between(-std::numbers::pi, std::numbers::pi));
}

Plot RandomStates::later_plot(const World& world, const Plot& plot, int scans) {
  const double reach = 0.5 * scans * world.scan_period_s;
  const Eigen::Vector2d moved(between(-reach, reach), between(-reach, reach));
  const Eigen::Vector2d there = to_cartesian(plot) + moved;
  return plot_at(there.norm(), std::atan2(there.y(), there.x()));
}

Gaussian RandomStates::prediction(const World& world) {
  const Plot first = plot();
  const int scans = count(3);
  return predict(world, two_plot_state(world, {}, first, later_plot(world, first, scans), scans));
}

Eigen::Matrix4d RandomStates::covariance() {
  Eigen::Vector4d sigma;
  Eigen::Matrix4d root = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 4; ++i) {
    sigma(i) = std::exp(i % 2 == 0 ? between(-5.0, 0.0) : between(-6.0, -1.0));
    root(i, i) = between(0.3, 1.0);
    for (int j = 0; j < i; ++j) root(i, j) = between(-1.0, 1.0);
  }
  const Eigen::Matrix4d factor = sigma.asDiagonal() * root;
  return factor * factor.transpose();
}

}  // namespace mda::testing
