// two_plot_state of the filter, in all its alternatives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/filter/ekf.h"
#include "scenarios/testing/random_states.h"

namespace mda::testing {
namespace {

using std::numbers::pi;

/// What two plots, in Cartesian coordinates, say about the state at the second by generalised least
/// squares: the first is seen from there through the transition backwards and its noise.
Gaussian least_squares(const World& world, const Plot& first, const Plot& second, int scans) {
  Eigen::Matrix<double, 2, 4> position = Eigen::Matrix<double, 2, 4>::Zero();
  position(0, 0) = position(1, 2) = 1.0;
  const Eigen::Matrix<double, 2, 4> back = position * transition(-scans * world.scan_period_s);
  Eigen::Matrix4d design;
  design << back, position;
  Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
  noise.topLeftCorner<2, 2>() =
      cartesian_covariance(world, first) +
      back * noise_of_both_axes(process_noise(world, scans)) * back.transpose();
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
  RandomStates draw(6);
  for (int i = 0; i < 200; ++i) {
    const Plot first = draw.plot();
    const int scans = draw.count(4);
    const Plot second = draw.later_plot(world, first, scans);
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
  RandomStates draw(7);
  double plain_steepest = 0.0;
  for (int i = 0; i < 100; ++i) {
    const Plot first = plot_at(draw.between(25.0, 50.0), draw.between(-pi, pi));
    const int scans = draw.count(2);
    const Plot second = draw.later_plot(world, first, scans);
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
  RandomStates draw(8);
  Eigen::Matrix<double, 2, 4> position = Eigen::Matrix<double, 2, 4>::Zero();
  position(0, 0) = position(1, 2) = 1.0;
  for (int i = 0; i < 100; ++i) {
    const Plot first = draw.plot();
    const Plot second = draw.later_plot(world, first, 1);
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
