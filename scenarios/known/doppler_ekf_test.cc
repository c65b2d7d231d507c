#include "scenarios/known/doppler_ekf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "scenarios/groups.h"

namespace mda::testing {
namespace {

const ScenarioSpec& spec() { return *find_scenario("battistelli-2"); }

/// Some target with correlated errors, `i` >= 0 telling which.
Gaussian some_state(int i) {
  Gaussian state;
  state.mean << 10.0 - 7.0 * i, 0.1, 20.0 + i, -0.05 * i;
  Eigen::Matrix4d root = Eigen::Vector4d(0.05, 0.004, 0.06, 0.005).asDiagonal();
  root(1, 0) = 0.002;
  root(2, 0) = 0.01 * i;
  root(3, 2) = -0.001;
  state.covariance = root * root.transpose();
  return state;
}

DopplerMeasurement near(const DopplerInnovation& expected, double sigmas) {
  return expected.plot + sigmas * expected.covariance.diagonal().cwiseSqrt();
}

TEST(DopplerEkfTest, MeasuresRangeBearingAndRangeRate) {
  const DopplerMeasurement away = measured({3.0, 0.3, 4.0, 0.4});
  EXPECT_NEAR(away(0), 5.0, 1e-12);
  EXPECT_NEAR(away(1), std::atan2(4.0, 3.0), 1e-12);
  EXPECT_NEAR(away(2), 0.5, 1e-12);
  EXPECT_NEAR(measured({3.0, -0.4, 4.0, 0.3})(2), 0.0, 1e-12) << "across";
  EXPECT_TRUE(measured({0.0, 1.0, 0.0, 1.0}).allFinite());
}

TEST(DopplerEkfTest, TheJacobianIsTheDerivative) {
  constexpr double kStep = 1e-6;
  const Eigen::Matrix3d noise = doppler_plot_covariance(spec());
  for (int i = 0; i < 3; ++i) {
    const Gaussian state = some_state(i);
    const DopplerInnovation expected = innovation(noise, state);
    for (int axis = 0; axis < 4; ++axis) {
      Gaussian low = state;
      Gaussian high = state;
      low.mean(axis) -= kStep;
      high.mean(axis) += kStep;
      const Eigen::Vector3d slope =
          (measured(state_of(high)) - measured(state_of(low))) / (2.0 * kStep);
      EXPECT_LT((expected.jacobian.col(axis) - slope).norm(), 1e-8);
    }
  }
}

TEST(DopplerEkfTest, LikelihoodIsTheNormalDensity) {
  for (int i = 0; i < 3; ++i) {
    const DopplerInnovation expected = innovation(doppler_plot_covariance(spec()), some_state(i));
    const DopplerMeasurement plot = near(expected, 0.7);
    const Eigen::Vector3d nu = plot - expected.plot;
    const double d2 = nu.dot(expected.covariance.llt().solve(nu));
    const Eigen::Matrix3d scaled = 2.0 * std::numbers::pi * expected.covariance;
    EXPECT_NEAR(std::exp(log_likelihood(expected, plot)) * std::sqrt(scaled.determinant()),
                std::exp(-0.5 * d2), 1e-9);
    EXPECT_NEAR(distance(expected, nu), d2, 1e-9);
  }
}

TEST(DopplerEkfTest, BearingsWrapAround) {
  Gaussian state = some_state(0);
  state.mean << -20.0, 0.1, 0.001, 0.0;
  const DopplerInnovation expected = innovation(doppler_plot_covariance(spec()), state);
  DopplerMeasurement plot = expected.plot;
  plot(1) -= 2.0 * std::numbers::pi - 0.001;
  EXPECT_NEAR(residual(expected, plot)(1), 0.001, 1e-12);
}

/// The information form of the update is another way to the same posterior.
TEST(DopplerEkfTest, UpdateAddsInformation) {
  const Eigen::Matrix3d noise = doppler_plot_covariance(spec());
  for (int i = 0; i < 3; ++i) {
    const Gaussian prior = some_state(i);
    const DopplerInnovation expected = innovation(noise, prior);
    const DopplerMeasurement plot = near(expected, -0.6);
    const Gaussian posterior = update(prior, expected, plot);
    const Eigen::Matrix4d information = prior.covariance.inverse() + expected.jacobian.transpose() *
                                                                         noise.inverse() *
                                                                         expected.jacobian;
    EXPECT_LT((posterior.covariance * information - Eigen::Matrix4d::Identity()).norm(), 1e-6);
    const Eigen::Vector4d step = information.ldlt().solve(
        expected.jacobian.transpose() * (noise.inverse() * residual(expected, plot)));
    EXPECT_LT((posterior.mean - prior.mean - step).norm(), 1e-8);
    EXPECT_EQ(posterior.covariance, posterior.covariance.transpose());
  }
}

/// A range rate that tells nothing leaves the update of range and bearing.
TEST(DopplerEkfTest, WithoutDopplerItIsThePlainFilter) {
  ScenarioSpec blind = spec();
  blind.known_targets->range_rate_sigma_km_s = 1e4;
  const Gaussian prior = some_state(1);
  const DopplerInnovation expected = innovation(doppler_plot_covariance(blind), prior);
  const DopplerMeasurement plot = near(expected, 0.0) + Eigen::Vector3d(0.02, 0.004, 5.0);
  const Gaussian with = update(prior, expected, plot);
  const Gaussian without =
      update(prior, innovation(blind.world, prior), Plot{plot(0), plot(1), kFalseAlarm});
  EXPECT_LT((with.mean - without.mean).norm(), 1e-6);
  EXPECT_LT((with.covariance - without.covariance).norm(), 1e-9);
}

TEST(DopplerEkfTest, NeedsKnownTargets) {
  EXPECT_THROW(static_cast<void>(doppler_plot_covariance(*find_scenario("A"))),
               std::invalid_argument);
}

}  // namespace
}  // namespace mda::testing
