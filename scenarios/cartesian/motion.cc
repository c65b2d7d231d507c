#include "scenarios/cartesian/motion.h"

#include <cmath>

#include "scenarios/filter/ekf.h"

namespace mda {
namespace {

MotionModel on_both_axes(const Eigen::Matrix3d& transition, const Eigen::Matrix3d& noise) {
  MotionModel model{MotionMatrix::Zero(), MotionMatrix::Zero()};
  for (int axis = 0; axis < 6; axis += 3) {
    model.transition.block<3, 3>(axis, axis) = transition;
    model.noise.block<3, 3>(axis, axis) = noise;
  }
  return model;
}

}  // namespace

MotionModel constant_velocity(const World& world) {
  const AxisNoise q = process_noise(world, 1);
  Eigen::Matrix3d transition;
  transition << 1.0, world.scan_period_s, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0;
  Eigen::Matrix3d noise;
  noise << q.pp, q.pv, 0.0, q.pv, q.vv, 0.0, 0.0, 0.0, 0.0;
  return on_both_axes(transition, noise);
}

MotionModel singer(double scan_period_s, double acceleration_sigma_km_s2, double time_s) {
  // The terms of pp cancel down to the fifth order of u, so that a period of a hundredth of the
  // time leaves it five digits.
  const double u = scan_period_s / time_s;
  const double e = std::exp(-u);
  const double e2 = e * e;
  Eigen::Matrix3d transition;
  transition << 1.0, scan_period_s, time_s * time_s * (u - 1.0 + e),  //
      0.0, 1.0, time_s * (1.0 - e),                                   //
      0.0, 0.0, e;
  const double pp = 0.5 * (1.0 - e2 + 2.0 * u + 2.0 / 3.0 * u * u * u - 2.0 * u * u - 4.0 * u * e);
  const double pv = 0.5 * (e2 + 1.0 - 2.0 * e + 2.0 * u * e - 2.0 * u + u * u);
  const double pa = 0.5 * (1.0 - e2 - 2.0 * u * e);
  const double vv = 0.5 * (4.0 * e - 3.0 - e2 + 2.0 * u);
  const double va = 0.5 * (e2 + 1.0 - 2.0 * e);
  const double aa = 0.5 * (1.0 - e2);
  const Eigen::Vector3d units(time_s * time_s, time_s, 1.0);
  Eigen::Matrix3d noise;
  noise << pp, pv, pa, pv, vv, va, pa, va, aa;
  const double variance = acceleration_sigma_km_s2 * acceleration_sigma_km_s2;
  noise = 2.0 * variance * units.asDiagonal() * noise * units.asDiagonal();
  MotionModel model = on_both_axes(transition, noise);
  model.acceleration_variance = variance;
  return model;
}

}  // namespace mda
