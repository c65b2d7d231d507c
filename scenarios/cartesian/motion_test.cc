#include "scenarios/cartesian/motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mda::testing {
namespace {

/// What an acceleration of 1 that fades with time constant `time_s` does to an axis in `t` seconds.
Eigen::Vector3d response(double t, double time_s) {
  const double fading = std::exp(-t / time_s);
  return {time_s * (t - time_s * (1.0 - fading)), time_s * (1.0 - fading), fading};
}

/// The white noise behind the acceleration has the density 2 sigma^2 / time, and what it adds is
/// the integral over when it strikes: composite Simpson.
Eigen::Matrix3d integrated_noise(double period_s, double sigma, double time_s) {
  constexpr int kSteps = 2000;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int i = 0; i <= kSteps; ++i) {
    const double weight = i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    const Eigen::Vector3d r = response(period_s * i / kSteps, time_s);
    sum += weight * r * r.transpose();
  }
  return sum * (period_s / (3.0 * kSteps)) * 2.0 * sigma * sigma / time_s;
}

TEST(MotionTest, SingerNoiseIsTheIntegralOfItsResponse) {
  for (const double period_s : {0.5, 1.0, 4.0}) {
    for (const double time_s : {2.0, 10.0, 30.0}) {
      SCOPED_TRACE(period_s / time_s);
      const MotionModel model = singer(period_s, 0.02, time_s);
      const Eigen::Matrix3d expected = integrated_noise(period_s, 0.02, time_s);
      for (int axis = 0; axis < 6; axis += 3) {
        const Eigen::Matrix3d noise = model.noise.block<3, 3>(axis, axis);
        for (int i = 0; i < 9; ++i) {
          EXPECT_NEAR(noise(i) / expected(i), 1.0, 1e-6) << noise << "\n" << expected;
        }
        const Eigen::Vector3d of_acceleration =
            model.transition.block<3, 3>(axis, axis) * Eigen::Vector3d::UnitZ();
        EXPECT_NEAR((of_acceleration - response(period_s, time_s)).norm(), 0.0, 1e-12);
      }
    }
  }
}

/// The variance of a first-order Markov process stays what it is.
TEST(MotionTest, SingerAccelerationIsStationary) {
  const MotionModel model = singer(1.0, 0.02, 10.0);
  MotionMatrix covariance = MotionMatrix::Zero();
  covariance(2, 2) = covariance(5, 5) = model.acceleration_variance;
  const MotionMatrix next =
      model.transition * covariance * model.transition.transpose() + model.noise;
  EXPECT_NEAR(next(2, 2), 0.02 * 0.02, 1e-15);
  EXPECT_NEAR(next(5, 5), 0.02 * 0.02, 1e-15);
  EXPECT_EQ(next(0, 3), 0.0);
}

/// F and G Q G^T of equation (17).
TEST(MotionTest, ConstantVelocityIsThePapersModel) {
  World world;
  world.scan_period_s = 2.0;
  world.acceleration_sigma_km_s2 = 0.005;
  const MotionModel model = constant_velocity(world);
  const Eigen::Vector2d g(2.0, 2.0);  // T^2 / 2, T
  for (int axis = 0; axis < 6; axis += 3) {
    const Eigen::Matrix2d noise = model.noise.block<2, 2>(axis, axis);
    EXPECT_NEAR((noise - 0.005 * 0.005 * g * g.transpose()).norm(), 0.0, 1e-15);
  }
  MotionVector state;
  state << 1.0, 0.1, 0.0, -3.0, 0.2, 0.0;
  MotionVector next;
  next << 1.2, 0.1, 0.0, -2.6, 0.2, 0.0;
  EXPECT_NEAR((model.transition * state - next).norm(), 0.0, 1e-12);
  EXPECT_EQ(model.acceleration_variance, 0.0);
}

}  // namespace
}  // namespace mda::testing
