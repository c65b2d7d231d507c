#include "scenarios/filter/ekf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "algorithms/testing/draw.h"

namespace mda::testing {
namespace {

using std::numbers::pi;

double between(Draw& draw, double low, double high) { return low + (high - low) * draw.unit(); }

Plot plot_at(double range_km, double bearing_rad) {
  Plot plot;
  plot.range_km = range_km;
  plot.bearing_rad = bearing_rad;
  return plot;
}

Plot random_plot(Draw& draw) { return plot_at(between(draw, 2.0, 50.0), between(draw, -pi, pi)); }

/// Where a target seen at `plot` may be seen `scans` periods later, well inside the gate.
Plot later_plot(Draw& draw, const World& world, const Plot& plot, int scans) {
  const double reach = 0.5 * scans * world.scan_period_s;
  const Eigen::Vector2d there = to_cartesian(plot) + Eigen::Vector2d(between(draw, -reach, reach),
                                                                     between(draw, -reach, reach));
  return plot_at(there.norm(), std::atan2(there.y(), there.x()));
}

Eigen::Matrix4d transition(double t) {
  Eigen::Matrix4d f = Eigen::Matrix4d::Identity();
  f(0, 1) = f(2, 3) = t;
  return f;
}

Eigen::Matrix4d in_both_axes(const AxisNoise& q) {
  Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
  for (int axis = 0; axis < 4; axis += 2) {
    noise(axis, axis) = q.pp;
    noise(axis, axis + 1) = noise(axis + 1, axis) = q.pv;
    noise(axis + 1, axis + 1) = q.vv;
  }
  return noise;
}

Gaussian random_prediction(Draw& draw, const World& world) {
  const Plot first = random_plot(draw);
  const int scans = 1 + draw.below(3);
  TrackerModel model;
  Gaussian state =
      two_plot_state(world, model, first, later_plot(draw, world, first, scans), scans);
  return predict(world, state);
}

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
  const Eigen::Matrix4d q = in_both_axes(process_noise(world, 1));
  Eigen::Matrix4d expected = Eigen::Matrix4d::Zero();
  for (int scans = 1; scans <= 6; ++scans) {
    expected = f * expected * f.transpose() + q;
    const Eigen::Matrix4d actual = in_both_axes(process_noise(world, scans));
    EXPECT_LE((actual - expected).norm(), 1e-14 * expected.norm());
  }
}

TEST(PredictTest, IsTheTransitionAndTheNoise) {
  const World world;
  Draw draw(1);
  for (int i = 0; i < 100; ++i) {
    const Gaussian state = random_prediction(draw, world);
    const Gaussian next = predict(world, state);
    const Eigen::Matrix4d f = transition(world.scan_period_s);
    EXPECT_LE((next.mean - f * state.mean).norm(), 1e-14 * next.mean.norm());
    const Eigen::Matrix4d expected =
        f * state.covariance * f.transpose() + in_both_axes(process_noise(world, 1));
    EXPECT_LE((next.covariance - expected).norm(), 1e-14 * expected.norm());
  }
}

TEST(InnovationTest, JacobianByFiniteDifferences) {
  const World world;
  Draw draw(2);
  for (int i = 0; i < 200; ++i) {
    const Gaussian state = random_prediction(draw, world);
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
  Draw draw(3);
  const Gaussian state = random_prediction(draw, world);
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
  Draw draw(4);
  const Eigen::Matrix2d sensor_information =
      Eigen::Vector2d(1.0 / (0.015 * 0.015), 1.0 / (0.0052 * 0.0052)).asDiagonal();
  for (int i = 0; i < 100; ++i) {
    const Gaussian prior = random_prediction(draw, world);
    const Innovation at = innovation(world, prior);
    const Plot plot =
        plot_at(at.plot(0) + between(draw, -0.2, 0.2), at.plot(1) + between(draw, -0.01, 0.01));
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
  Draw draw(5);
  for (int i = 0; i < 100; ++i) {
    const Plot plot = random_plot(draw);
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

/// What two plots, in Cartesian coordinates, say about the state at the second by generalised least
/// squares: the first is seen from there through the transition backwards and its noise.
Gaussian least_squares(const World& world, const Plot& first, const Plot& second, int scans) {
  Eigen::Matrix<double, 2, 4> position = Eigen::Matrix<double, 2, 4>::Zero();
  position(0, 0) = position(1, 2) = 1.0;
  const Eigen::Matrix<double, 2, 4> back = position * transition(-scans * world.scan_period_s);
  Eigen::Matrix4d design;
  design << back, position;
  Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
  noise.topLeftCorner<2, 2>() = cartesian_covariance(world, first) +
                                back * in_both_axes(process_noise(world, scans)) * back.transpose();
  noise.bottomRightCorner<2, 2>() = cartesian_covariance(world, second);
  Eigen::Vector4d seen;
  seen << to_cartesian(first), to_cartesian(second);
  const Eigen::Matrix4d weight = noise.inverse();
  const Eigen::Matrix4d covariance = (design.transpose() * weight * design).inverse();
  return {covariance * (design.transpose() * (weight * seen)), covariance};
}

TEST(TwoPlotStateTest, DifferencingIsGeneralisedLeastSquares) {
  const World world;
  const TrackerModel model;
  Draw draw(6);
  for (int i = 0; i < 200; ++i) {
    const Plot first = random_plot(draw);
    const int scans = 1 + draw.below(4);
    const Plot second = later_plot(draw, world, first, scans);
    const Gaussian actual = two_plot_state(world, model, first, second, scans);
    const Gaussian expected = least_squares(world, first, second, scans);
    EXPECT_LE((actual.mean - expected.mean).norm(), 1e-8 * expected.mean.norm());
    EXPECT_LE((actual.covariance - expected.covariance).norm(), 1e-8 * expected.covariance.norm());
  }
}

/// Half the squared distances from the prior and from the plot: what the posterior mode minimises.
double posterior_nats(const World& world, const Gaussian& prior, const Plot& plot,
                      const Eigen::Vector4d& at) {
  const Eigen::Vector4d from_prior = at - prior.mean;
  const Eigen::Vector2d nu = residual(innovation(world, {at, prior.covariance}), plot);
  return 0.5 * from_prior.dot(prior.covariance.inverse() * from_prior) +
         0.5 * (nu(0) * nu(0) / (0.015 * 0.015) + nu(1) * nu(1) / (0.0052 * 0.0052));
}

Gaussian prior_of_second_plot(const World& world, const TrackerModel& model, const Plot& first,
                              int scans) {
  Gaussian prior = newborn_state(world, model, first);
  for (int i = 0; i < scans; ++i) prior = predict(world, prior);
  return prior;
}

/// The slope of posterior_nats along the axes of the posterior, one standard deviation each.
double steepest_slope(const World& world, const Gaussian& prior, const Plot& plot,
                      const Gaussian& posterior) {
  const Eigen::Matrix4d root = posterior.covariance.llt().matrixL();
  double steepest = 0.0;
  for (int axis = 0; axis < 4; ++axis) {
    const Eigen::Vector4d step = 1e-3 * root.col(axis);
    const double slope = (posterior_nats(world, prior, plot, posterior.mean + step) -
                          posterior_nats(world, prior, plot, posterior.mean - step)) /
                         2e-3;
    steepest = std::max(steepest, std::abs(slope));
  }
  return steepest;
}

TEST(TwoPlotStateTest, IteratedFilterFindsTheModeOfThePosterior) {
  const World world;
  TrackerModel iterated;
  iterated.second_plot = SecondPlot::kIteratedEkf;
  TrackerModel plain;
  plain.second_plot = SecondPlot::kPlainEkf;
  Draw draw(7);
  double plain_steepest = 0.0;
  for (int i = 0; i < 100; ++i) {
    const Plot first = plot_at(between(draw, 25.0, 50.0), between(draw, -pi, pi));
    const int scans = 1 + draw.below(2);
    const Plot second = later_plot(draw, world, first, scans);
    const Gaussian prior = prior_of_second_plot(world, iterated, first, scans);
    const auto slope = [&](const TrackerModel& model) {
      return steepest_slope(world, prior, second,
                            two_plot_state(world, model, first, second, scans));
    };
    EXPECT_LE(slope(iterated), 1e-3);
    plain_steepest = std::max(plain_steepest, slope(plain));
  }
  EXPECT_GE(plain_steepest, 1.0) << "one update would have done: the test shows nothing";
}

TEST(TwoPlotStateTest, PlainFilterIsOneUpdate) {
  const World world;
  TrackerModel model;
  model.second_plot = SecondPlot::kPlainEkf;
  const Plot first = plot_at(30.0, 1.0);
  const Plot second = plot_at(33.0, 1.05);
  const Gaussian prior = prior_of_second_plot(world, model, first, 2);
  const Gaussian expected = update(prior, innovation(world, prior), second);
  const Gaussian actual = two_plot_state(world, model, first, second, 2);
  EXPECT_LE((actual.mean - expected.mean).norm(), 1e-14 * expected.mean.norm());
  EXPECT_LE((actual.covariance - expected.covariance).norm(), 1e-14);
}

/// In Cartesian coordinates all is linear: the information form once more.
TEST(TwoPlotStateTest, ConvertedPlotIsALinearUpdate) {
  const World world;
  TrackerModel model;
  model.second_plot = SecondPlot::kConverted;
  Draw draw(8);
  Eigen::Matrix<double, 2, 4> position = Eigen::Matrix<double, 2, 4>::Zero();
  position(0, 0) = position(1, 2) = 1.0;
  for (int i = 0; i < 100; ++i) {
    const Plot first = random_plot(draw);
    const Plot second = later_plot(draw, world, first, 1);
    const Gaussian prior = prior_of_second_plot(world, model, first, 1);
    const Eigen::Matrix2d weight = cartesian_covariance(world, second).inverse();
    const Eigen::Matrix4d covariance =
        (prior.covariance.inverse() + position.transpose() * weight * position).inverse();
    const Eigen::Vector2d nu = to_cartesian(second) - position * prior.mean;
    const Eigen::Vector4d mean = prior.mean + covariance * (position.transpose() * (weight * nu));
    const Gaussian actual = two_plot_state(world, model, first, second, 1);
    EXPECT_LE((actual.mean - mean).norm(), 1e-8 * mean.norm());
    EXPECT_LE((actual.covariance - covariance).norm(), 1e-8 * covariance.norm());
  }
}

}  // namespace
}  // namespace mda::testing
