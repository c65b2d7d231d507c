#include "scenarios/filter/ekf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scenarios/testing/random_states.h"

namespace mda::testing {
namespace {

using std::numbers::pi;

/// An acceleration a that lasts one period, i periods ago, leaves the velocity T a and the position
/// T^2 (i + 1/2) a behind.
TEST(ProcessNoiseTest, IsThatOfOneAccelerationPerPeriod) {
  World world;
  world.scan_period_s = 3.0;
  world.acceleration_sigma_km_s2 = 0.02;
  AxisNoise expected;
  for (int scans = 0; scans <= 6; ++scans) {
    const AxisNoise actual = process_noise(world, scans);
    EXPECT_NEAR(actual.pp, expected.pp, 1e-14 * (1.0 + expected.pp));
    EXPECT_NEAR(actual.pv, expected.pv, 1e-14 * (1.0 + expected.pv));
    EXPECT_NEAR(actual.vv, expected.vv, 1e-14 * (1.0 + expected.vv));
    const double to_velocity = 3.0 * 0.02;
    const double to_position = 9.0 * (scans + 0.5) * 0.02;
    expected.pp += to_position * to_position;
    expected.pv += to_position * to_velocity;
    expected.vv += to_velocity * to_velocity;
  }
}

TEST(ProcessNoiseTest, AccumulatesThroughTheTransition) {
  const World world;
  const Eigen::Matrix4d f = transition(world.scan_period_s);
  const Eigen::Matrix4d q = noise_of_both_axes(process_noise(world, 1));
  Eigen::Matrix4d expected = Eigen::Matrix4d::Zero();
  for (int scans = 1; scans <= 6; ++scans) {
    expected = f * expected * f.transpose() + q;
    const Eigen::Matrix4d actual = noise_of_both_axes(process_noise(world, scans));
    EXPECT_LE((actual - expected).norm(), 1e-14 * expected.norm());
  }
}

TEST(PredictTest, IsTheTransitionAndTheNoise) {
  const World world;
  RandomStates draw(1);
  for (int i = 0; i < 100; ++i) {
    const Gaussian state = draw.prediction(world);
    const Gaussian next = predict(world, state);
    const Eigen::Matrix4d f = transition(world.scan_period_s);
    EXPECT_LE((next.mean - f * state.mean).norm(), 1e-14 * next.mean.norm());
    const Eigen::Matrix4d expected =
        f * state.covariance * f.transpose() + noise_of_both_axes(process_noise(world, 1));
    EXPECT_LE((next.covariance - expected).norm(), 1e-14 * expected.norm());
  }
}

TEST(InnovationTest, JacobianByFiniteDifferences) {
  const World world;
  RandomStates draw(2);
  for (int i = 0; i < 200; ++i) {
    const Gaussian state = draw.prediction(world);
    const Innovation at = innovation(world, state);
    for (int axis = 0; axis < 4; ++axis) {
      const double step = 1e-5;
      Gaussian ahead = state;
      Gaussian behind = state;
      ahead.mean(axis) += step;
      behind.mean(axis) -= step;
      const Plot there =
          plot_at(innovation(world, ahead).plot(0), innovation(world, ahead).plot(1));
      const Eigen::Vector2d slope = residual(innovation(world, behind), there) / (2.0 * step);
      EXPECT_LE((slope - at.jacobian.col(axis)).norm(), 1e-8);
    }
  }
}

TEST(InnovationTest, CovarianceIsTheStatesAndTheSensors) {
  const World world;
  RandomStates draw(3);
  const Gaussian state = draw.prediction(world);
  const Innovation at = innovation(world, state);
  Eigen::Matrix2d sensor = Eigen::Matrix2d::Zero();
  sensor(0, 0) = 0.015 * 0.015;
  sensor(1, 1) = 0.0052 * 0.0052;
  const Eigen::Matrix2d expected =
      at.jacobian * state.covariance * at.jacobian.transpose() + sensor;
  EXPECT_LE((at.covariance - expected).norm(), 1e-14 * expected.norm());
}

TEST(InnovationTest, IsFiniteOverTheRadar) {
  Gaussian state;
  state.mean.setZero();
  state.covariance = 0.01 * Eigen::Matrix4d::Identity();
  const Innovation at = innovation(World{}, state);
  EXPECT_TRUE(at.jacobian.allFinite());
  EXPECT_TRUE(update(state, at, plot_at(0.1, 1.0)).covariance.allFinite());
}

TEST(ResidualTest, TakesTheShortWayRound) {
  Innovation expected;
  expected.plot << 10.0, pi - 0.01;
  EXPECT_NEAR(residual(expected, plot_at(10.5, -pi + 0.02))(1), 0.03, 1e-12);
  EXPECT_NEAR(residual(expected, plot_at(10.5, pi - 0.03))(1), -0.02, 1e-12);
  EXPECT_NEAR(residual(expected, plot_at(10.5, 0.0))(0), 0.5, 1e-12);
  expected.plot(1) = -pi + 0.01;
  EXPECT_NEAR(residual(expected, plot_at(10.5, pi - 0.02))(1), -0.03, 1e-12);
}

/// The update in information form: P^-1 + H' R^-1 H.
TEST(UpdateTest, EqualsTheInformationForm) {
  const World world;
  RandomStates draw(4);
  const Eigen::Matrix2d sensor_information =
      Eigen::Vector2d(1.0 / (0.015 * 0.015), 1.0 / (0.0052 * 0.0052)).asDiagonal();
  for (int i = 0; i < 100; ++i) {
    const Gaussian prior = draw.prediction(world);
    const Innovation at = innovation(world, prior);
    const Plot plot =
        plot_at(at.plot(0) + draw.between(-0.2, 0.2), at.plot(1) + draw.between(-0.01, 0.01));
    const Gaussian posterior = update(prior, at, plot);
    const Eigen::Matrix4d information =
        prior.covariance.inverse() + at.jacobian.transpose() * sensor_information * at.jacobian;
    const Eigen::Matrix4d covariance = information.inverse();
    const Eigen::Vector4d mean =
        prior.mean +
        covariance * (at.jacobian.transpose() * sensor_information * residual(at, plot));
    EXPECT_LE((posterior.covariance - covariance).norm(), 1e-9 * covariance.norm());
    EXPECT_LE((posterior.mean - mean).norm(), 1e-9 * (posterior.mean - prior.mean).norm());
  }
}

TEST(CartesianTest, CovarianceIsTheSensorsThroughTheJacobian) {
  const World world;
  RandomStates draw(5);
  for (int i = 0; i < 100; ++i) {
    const Plot plot = draw.plot();
    const double step = 1e-6;
    Eigen::Matrix2d jacobian;
    jacobian.col(0) = (to_cartesian(plot_at(plot.range_km + step, plot.bearing_rad)) -
                       to_cartesian(plot_at(plot.range_km - step, plot.bearing_rad))) /
                      (2.0 * step);
    jacobian.col(1) = (to_cartesian(plot_at(plot.range_km, plot.bearing_rad + step)) -
                       to_cartesian(plot_at(plot.range_km, plot.bearing_rad - step))) /
                      (2.0 * step);
    const Eigen::Vector2d variance(0.015 * 0.015, 0.0052 * 0.0052);
    const Eigen::Matrix2d expected = jacobian * variance.asDiagonal() * jacobian.transpose();
    EXPECT_LE((cartesian_covariance(world, plot) - expected).norm(), 1e-8 * expected.norm());
  }
}

TEST(NewbornTest, StandsAtItsPlotAndMayMoveAnyWhere) {
  World world;
  world.speed_max_km_s = 0.5;
  TrackerModel model;
  model.velocity_prior = 0.4;
  const Plot plot = plot_at(20.0, 2.0);
  const Gaussian state = newborn_state(world, model, plot);
  const Eigen::Vector2d position(state.mean(0), state.mean(2));
  EXPECT_LE((position - to_cartesian(plot)).norm(), 1e-14);
  EXPECT_EQ(state.mean(1), 0.0);
  EXPECT_EQ(state.mean(3), 0.0);
  for (const int velocity : {1, 3}) {
    EXPECT_NEAR(state.covariance(velocity, velocity), 0.04, 1e-15);
    EXPECT_NEAR(state.covariance.row(velocity).norm(), 0.04, 1e-15) << "uncorrelated";
  }
  const Eigen::Matrix2d expected = cartesian_covariance(world, plot);
  EXPECT_EQ(state.covariance(0, 2), expected(0, 1));
  EXPECT_EQ(state.covariance(2, 2), expected(1, 1));
}

}  // namespace
}  // namespace mda::testing
