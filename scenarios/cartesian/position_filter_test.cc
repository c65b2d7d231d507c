#include "scenarios/cartesian/position_filter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "scenarios/world/draws.h"

namespace mda::testing {
namespace {

constexpr double kSigmaKm = 0.15;

using Observation = Eigen::Matrix<double, 2, 6>;

Observation observation() {
  Observation h = Observation::Zero();
  h(0, 0) = 1.0;
  h(1, 3) = 1.0;
  return h;
}

struct Case {
  MotionEstimate predicted;
  std::vector<WeightedPlot> plots;  ///< weights add up to less than 1
};

Case random_case(std::uint64_t seed) {
  auto engine = draws({.seed = seed, .scenario = "filter"});
  Case c;
  MotionMatrix root;
  for (int i = 0; i < 6; ++i) {
    c.predicted.mean(i) = draw_normal(engine, 1.0);
    for (int j = 0; j < 6; ++j) root(i, j) = draw_normal(engine, 0.2);
  }
  c.predicted.covariance = root * root.transpose() + 1e-3 * MotionMatrix::Identity();
  const int count = 1 + draw_poisson(engine, 2.0);
  for (int i = 0; i < count; ++i) {
    const double x = c.predicted.mean(0) + draw_normal(engine, 0.4);
    const double y = c.predicted.mean(3) + draw_normal(engine, 0.4);
    c.plots.push_back({{x, y}, draw_uniform(engine, 0.0, 1.0) / count});
  }
  return c;
}

/// The Kalman update in information form: P^-1 + H^T R^-1 H.
MotionEstimate by_information(const MotionEstimate& predicted, const Eigen::Vector2d& plot) {
  const Observation h = observation();
  const double precision = 1.0 / (kSigmaKm * kSigmaKm);
  MotionEstimate result;
  const MotionMatrix before = predicted.covariance.inverse();
  result.covariance = (before + precision * h.transpose() * h).inverse();
  result.mean = result.covariance * (before * predicted.mean + precision * h.transpose() * plot);
  return result;
}

double least_eigenvalue(const MotionMatrix& m) {
  return Eigen::SelfAdjointEigenSolver<MotionMatrix>(m).eigenvalues()(0);
}

TEST(PositionFilterTest, OnePlotOfWeightOneIsTheKalmanUpdate) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = random_case(seed);
    const WeightedPlot sure{c.plots[0].position, 1.0};
    const MotionEstimate one =
        update(c.predicted, innovation(kSigmaKm, c.predicted), kSigmaKm, {&sure, 1});
    const MotionEstimate expected = by_information(c.predicted, sure.position);
    EXPECT_NEAR((one.mean - expected.mean).norm(), 0.0, 1e-9);
    EXPECT_NEAR((one.covariance - expected.covariance).norm(), 0.0, 1e-9);
    EXPECT_EQ(one.covariance, one.covariance.transpose());
  }
}

/// Mean and covariance of the mixture of what each plot alone, and none, would make of it.
TEST(PositionFilterTest, SoftUpdateHasTheMomentsOfTheMixture) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = random_case(seed);
    std::vector<std::pair<double, MotionEstimate>> parts;
    double none = 1.0;
    for (const WeightedPlot& plot : c.plots) {
      parts.emplace_back(plot.weight, by_information(c.predicted, plot.position));
      none -= plot.weight;
    }
    parts.emplace_back(none, c.predicted);
    MotionVector mean = MotionVector::Zero();
    for (const auto& [weight, part] : parts) mean += weight * part.mean;
    MotionMatrix covariance = MotionMatrix::Zero();
    for (const auto& [weight, part] : parts) {
      const MotionVector off = part.mean - mean;
      covariance += weight * (part.covariance + off * off.transpose());
    }
    const MotionEstimate soft =
        update(c.predicted, innovation(kSigmaKm, c.predicted), kSigmaKm, c.plots);
    EXPECT_NEAR((soft.mean - mean).norm(), 0.0, 1e-9);
    EXPECT_NEAR((soft.covariance - covariance).norm(), 0.0, 1e-9);
    EXPECT_EQ(soft.covariance, soft.covariance.transpose());
    const MotionMatrix sharpest = by_information(c.predicted, c.plots[0].position).covariance;
    EXPECT_GE(least_eigenvalue(soft.covariance - sharpest), -1e-12) << "no doubt is free";
  }
}

TEST(PositionFilterTest, WithoutPlotsNothingChanges) {
  const Case c = random_case(1);
  const MotionEstimate same = update(c.predicted, innovation(kSigmaKm, c.predicted), kSigmaKm, {});
  EXPECT_EQ(same.mean, c.predicted.mean);
  EXPECT_EQ(same.covariance, c.predicted.covariance);
}

TEST(PositionFilterTest, TheOrderOfPlotsDoesNotMatter) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Case c = random_case(seed);
    const PositionInnovation expected = innovation(kSigmaKm, c.predicted);
    const MotionEstimate before = update(c.predicted, expected, kSigmaKm, c.plots);
    std::reverse(c.plots.begin(), c.plots.end());
    const MotionEstimate after = update(c.predicted, expected, kSigmaKm, c.plots);
    EXPECT_NEAR((before.mean - after.mean).norm(), 0.0, 1e-12);
    EXPECT_NEAR((before.covariance - after.covariance).norm(), 0.0, 1e-12);
  }
}

TEST(PositionFilterTest, WeightsBeyondOneLeaveACovariance) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Case c = random_case(seed);
    for (WeightedPlot& plot : c.plots) plot.weight *= 4.0;
    const MotionEstimate raw =
        update(c.predicted, innovation(kSigmaKm, c.predicted), kSigmaKm, c.plots);
    EXPECT_GE(least_eigenvalue(raw.covariance), -1e-12) << seed;
  }
}

TEST(PositionFilterTest, LikelihoodIsThatOfANormalDistribution) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Case c = random_case(seed);
    const Observation h = observation();
    const Eigen::Matrix2d s = h * c.predicted.covariance * h.transpose() +
                              kSigmaKm * kSigmaKm * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d nu = c.plots[0].position - h * c.predicted.mean;
    const double distance = nu.dot(s.llt().solve(nu));
    const PositionInnovation expected = innovation(kSigmaKm, c.predicted);
    EXPECT_NEAR(expected.distance(c.plots[0].position), distance, 1e-9 * (1.0 + distance));
    EXPECT_NEAR(std::exp(expected.log_peak),
                1.0 / (2.0 * std::numbers::pi * std::sqrt(s.determinant())), 1e-9);
  }
}

/// Of two plots of a target that does not accelerate, the estimate's error has its covariance.
TEST(PositionFilterTest, TwoPlotEstimateIsConsistent) {
  World world;
  world.scan_period_s = 2.0;
  const MotionModel model = singer(2.0, 0.02, 10.0);
  auto engine = draws({.scenario = "two plots"});
  constexpr int kCases = 4000;
  const std::array<int, 4> seen = {0, 1, 3, 4};
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  Eigen::Matrix4d stated;
  for (int n = 0; n < kCases; ++n) {
    const auto error = [&] { return draw_normal(engine, kSigmaKm); };
    const double x0 = error();
    const double y0 = error();
    const double x1 = error();
    const double y1 = error();
    const MotionEstimate e = two_plot_estimate(model, kSigmaKm, 2.0, {x0, y0}, {x1, y1});
    Eigen::Vector4d off;
    for (int i = 0; i < 4; ++i) {
      off(i) = e.mean(seen[static_cast<std::size_t>(i)]);
      for (int j = 0; j < 4; ++j) {
        stated(i, j) =
            e.covariance(seen[static_cast<std::size_t>(i)], seen[static_cast<std::size_t>(j)]);
      }
    }
    sum += off * off.transpose();
    EXPECT_EQ(e.covariance(2, 2), 0.02 * 0.02);
  }
  const double sigma = std::sqrt(2.0 / kCases);  // of a mean of squared standard normals
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double scale = std::sqrt(stated(i, i) * stated(j, j));
      EXPECT_NEAR(sum(i, j) / kCases, stated(i, j), 5.0 * sigma * scale);
    }
  }
}

TEST(PositionFilterTest, WithoutALikelihoodItThrows) {
  MotionEstimate sure;
  EXPECT_THROW(static_cast<void>(innovation(0.0, sure)), std::runtime_error);
  EXPECT_NO_THROW(static_cast<void>(innovation(kSigmaKm, sure)));
  sure.covariance(0, 0) = -1.0;
  EXPECT_THROW(static_cast<void>(innovation(kSigmaKm, sure)), std::runtime_error);
  sure.covariance(0, 0) = std::nan("");
  EXPECT_THROW(static_cast<void>(innovation(kSigmaKm, sure)), std::runtime_error);
  MotionEstimate nowhere;
  nowhere.mean(0) = std::nan("");
  EXPECT_THROW(static_cast<void>(innovation(kSigmaKm, nowhere)), std::runtime_error);
}

}  // namespace
}  // namespace mda::testing
