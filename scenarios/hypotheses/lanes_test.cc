#include "scenarios/hypotheses/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include "scenarios/filter/ekf.h"
#include "scenarios/testing/random_states.h"

namespace mda::testing {
namespace {

using std::numbers::pi;

/// Every version of the kernel that this processor can run.
std::vector<PredictLanes> versions() {
  std::vector<PredictLanes> all = {predict_lanes_baseline()};
  if (predict_lanes_for_this_cpu() != all[0]) all.push_back(predict_lanes_for_this_cpu());
  return all;
}

/// Somewhere between 0.5 and 60 km from the radar.
Gaussian random_state(RandomStates& draw) {
  const double range = draw.between(0.5, 60.0);
  const double bearing = draw.between(-pi, pi);
  Gaussian state;
  state.mean << range * std::cos(bearing), draw.between(-1.0, 1.0), range * std::sin(bearing),
      draw.between(-1.0, 1.0);
  state.covariance = draw.covariance();
  return state;
}

void put(Lanes& lanes, int lane, const Gaussian& state) {
  LaneState packed{};
  for (int row = 0, entry = 0; row < 4; ++row) {
    packed.x[row] = state.mean(row);
    for (int column = row; column < 4; ++column) {
      packed.p[entry++] = state.covariance(row, column);
    }
  }
  lanes.put(lane, packed);
}

void set_interval(Lanes& lanes, int lane, const World& world, int scans) {
  const AxisNoise noise = process_noise(world, scans);
  lanes.dt[lane] = scans * world.scan_period_s;
  lanes.noise_pp[lane] = noise.pp;
  lanes.noise_pv[lane] = noise.pv;
  lanes.noise_vv[lane] = noise.vv;
}

LaneModel model_of(const World& world) {
  return {world.range_sigma_km * world.range_sigma_km,
          world.bearing_sigma_rad * world.bearing_sigma_rad, 1.25, 9.21};
}

/// Expects two matrices to be equal to 1e-12 of what their rows and columns measure in.
template <typename Matrix, typename Rows, typename Columns>
void expect_close(const Matrix& actual, const Matrix& expected, const Rows& row_scale,
                  const Columns& column_scale) {
  for (int i = 0; i < actual.rows(); ++i) {
    for (int j = 0; j < actual.cols(); ++j) {
      EXPECT_NEAR(actual(i, j), expected(i, j), 1e-12 * row_scale(i) * column_scale(j))
          << "entry " << i << ", " << j;
    }
  }
}

void expect_like_filter(const Lanes& lanes, int lane, const World& world, Gaussian state,
                        int scans) {
  for (int i = 0; i < scans; ++i) state = predict(world, state);
  const Innovation expected = innovation(world, state);
  const Eigen::Vector4d sigma = state.covariance.diagonal().cwiseSqrt();
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(lanes.x[i][lane], state.mean(i), 1e-12 * state.mean.cwiseAbs().maxCoeff());
  }
  EXPECT_NEAR(lanes.range[lane], expected.plot(0), 1e-12 * expected.plot(0));
  EXPECT_NEAR(lanes.bearing[lane], expected.plot(1), 1e-12);

  // The inverse amplifies rounding by the condition number of B in its own units.
  const Eigen::Vector2d plot_sigma = expected.covariance.diagonal().cwiseSqrt();
  const double correlation = expected.covariance(0, 1) / (plot_sigma(0) * plot_sigma(1));
  const double condition = 1.0 / (1.0 - correlation * correlation);
  const Eigen::Vector2d inverse_scale = plot_sigma.cwiseInverse() * condition;
  Eigen::Matrix2d inverse;
  inverse << lanes.inverse_rr[lane], lanes.inverse_rb[lane], lanes.inverse_rb[lane],
      lanes.inverse_bb[lane];
  const Eigen::Matrix2d expected_inverse = expected.covariance.inverse();
  expect_close(inverse, expected_inverse, inverse_scale, inverse_scale);
  EXPECT_NEAR(lanes.cost[lane] - 1.25, 0.5 * std::log(expected.covariance.determinant()),
              1e-12 * condition);

  Eigen::Matrix<double, 4, 2> gain;
  Eigen::Matrix4d updated;
  for (int i = 0, entry = 0; i < 4; ++i) {
    gain.row(i) << lanes.gain_range[i][lane], lanes.gain_bearing[i][lane];
    for (int j = i; j < 4; ++j) updated(i, j) = updated(j, i) = lanes.updated[entry++][lane];
  }
  const Eigen::Matrix<double, 4, 2> expected_gain =
      state.covariance * expected.jacobian.transpose() * expected_inverse;
  expect_close(gain, expected_gain, sigma, inverse_scale);
  const Plot plot{expected.plot(0), expected.plot(1), kFalseAlarm};
  const Eigen::Matrix4d expected_updated = update(state, expected, plot).covariance;
  expect_close(updated, expected_updated, Eigen::Vector4d(sigma * condition), sigma);
}

TEST(LanesTest, AgreeWithThePlainFilter) {
  const World world;
  RandomStates draw(1);
  const auto lanes = std::make_unique<Lanes>();
  for (const PredictLanes version : versions()) {
    for (int block = 0; block < 50; ++block) {
      std::vector<Gaussian> states;
      for (int lane = 0; lane < kLanes; ++lane) {
        states.push_back(random_state(draw));
        put(*lanes, lane, states.back());
        set_interval(*lanes, lane, world, 1 + lane % 4);
      }
      const int n = block % 2 == 0 ? kLanes : draw.count(kLanes);
      version(model_of(world), 1.0, 100.0, *lanes, n);
      for (int lane = 0; lane < n; ++lane) {
        expect_like_filter(*lanes, lane, world, states[static_cast<std::size_t>(lane)],
                           1 + lane % 4);
      }
    }
  }
}

/// One block with the given positions, at rest and known exactly.
std::unique_ptr<Lanes> standing_at(const std::vector<std::pair<double, double>>& positions) {
  auto lanes = std::make_unique<Lanes>();
  std::memset(static_cast<void*>(lanes.get()), 0, sizeof(Lanes));
  for (std::size_t lane = 0; lane < positions.size(); ++lane) {
    lanes->x[0][lane] = positions[lane].first;
    lanes->x[2][lane] = positions[lane].second;
  }
  return lanes;
}

/// Of half a unit in the last place of pi, 2.2e-16, comes from rounding the result; the rest is the
/// series' and its argument's.
TEST(LanesTest, BearingIsTheAngle) {
  constexpr double kToleranceRad = 6e-16;
  RandomStates draw(2);
  std::vector<std::pair<double, double>> positions = {{1, 0},     {-1, 0},     {0, 1},  {0, -1},
                                                      {1, 1},     {-1, 1},     {1, -1}, {-1, -1},
                                                      {50, 1e-9}, {-50, -1e-9}};
  while (positions.size() < 1000 * kLanes) {
    const double range = std::exp(draw.between(-7.0, 5.0));
    const double bearing = draw.between(-pi, pi);
    positions.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  double worst = 0.0;
  for (const PredictLanes version : versions()) {
    for (std::size_t begin = 0; begin < positions.size(); begin += kLanes) {
      const std::vector<std::pair<double, double>> block(
          positions.begin() + static_cast<std::ptrdiff_t>(begin),
          positions.begin() + static_cast<std::ptrdiff_t>(begin) + kLanes);
      const auto lanes = standing_at(block);
      version(model_of(World{}), 1.0, 100.0, *lanes, kLanes);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const long double exact = std::atan2(static_cast<long double>(block[lane].second),
                                             static_cast<long double>(block[lane].first));
        const long double error = static_cast<long double>(lanes->bearing[lane]) - exact;
        worst = std::max(worst, std::abs(static_cast<double>(error)));
      }
    }
  }
  EXPECT_LE(worst, kToleranceRad);
}

/// On the x axis at 1 km, with a perfect range and a bearing of variance 1 and no error of its own,
/// det B is the variance of x: the cost is half its logarithm. Errors are counted in units of the
/// larger of 1 and the logarithm; rounding the logarithm and halving it costs 1.1e-16.
TEST(LanesTest, CostHoldsTheLogarithm) {
  constexpr double kTolerance = 4e-16;
  const LaneModel model{0.0, 1.0, 0.0, 9.21};
  RandomStates draw(3);
  std::vector<double> variances = {1.0,
                                   std::numbers::sqrt2,
                                   0.5 * std::numbers::sqrt2,
                                   std::nextafter(1.0, 0.0),
                                   std::nextafter(1.0, 2.0),
                                   0x1p-1000};
  while (variances.size() < 1000 * kLanes) {
    const bool near_one = variances.size() % 2 == 0;
    variances.push_back(std::exp(near_one ? draw.between(-1.0, 1.0) : draw.between(-60.0, 10.0)));
  }
  double worst = 0.0;
  for (const PredictLanes version : versions()) {
    for (std::size_t begin = 0; begin < variances.size(); begin += kLanes) {
      const auto lanes = standing_at(std::vector<std::pair<double, double>>(kLanes, {1.0, 0.0}));
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        lanes->p[0][lane] = variances[begin + lane];
      }
      version(model, 1.0, 100.0, *lanes, kLanes);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const long double exact = std::log(static_cast<long double>(variances[begin + lane]));
        const long double error = 2.0L * static_cast<long double>(lanes->cost[lane]) - exact;
        worst =
            std::max(worst, static_cast<double>(std::abs(error) / std::max(1.0L, std::abs(exact))));
      }
    }
  }
  EXPECT_LE(worst, kTolerance);
}

/// The buckets hold every range that can lie within the gate, and few more.
TEST(LanesTest, BucketsSpanTheGate) {
  const World world;
  const LaneModel model = model_of(world);
  RandomStates draw(4);
  const auto lanes = std::make_unique<Lanes>();
  constexpr double kBucketsPerKm = 2.0;
  constexpr double kLastBucket = 101.0;
  for (int block = 0; block < 20; ++block) {
    std::vector<Gaussian> states;
    for (int lane = 0; lane < kLanes; ++lane) {
      states.push_back(random_state(draw));
      put(*lanes, lane, states.back());
      set_interval(*lanes, lane, world, 1);
    }
    predict_lanes_for_this_cpu()(model, kBucketsPerKm, kLastBucket, *lanes, kLanes);
    for (int lane = 0; lane < kLanes; ++lane) {
      const Innovation expected =
          innovation(world, predict(world, states[static_cast<std::size_t>(lane)]));
      const double half = std::sqrt(model.gate * expected.covariance(0, 0));
      const auto bucket = [&](double range) { return std::floor(range * kBucketsPerKm); };
      const double first = std::clamp(bucket(expected.plot(0) - half), 0.0, kLastBucket);
      const double end = std::min(bucket(expected.plot(0) + half) + 1.0, kLastBucket);
      EXPECT_EQ(lanes->first_bucket[lane], first);
      EXPECT_EQ(lanes->end_bucket[lane], end);
    }
  }
}

TEST(LanesTest, VersionsAgreeBitByBit) {
  if (versions().size() == 1) GTEST_SKIP() << "this processor has no AVX2: there is one version";
  const World world;
  RandomStates draw(5);
  const auto a = std::make_unique<Lanes>();
  const auto b = std::make_unique<Lanes>();
  for (int block = 0; block < 500; ++block) {
    std::memset(static_cast<void*>(a.get()), 0, sizeof(Lanes));
    for (int lane = 0; lane < kLanes; ++lane) {
      put(*a, lane, random_state(draw));
      set_interval(*a, lane, world, draw.count(4));
    }
    std::memcpy(static_cast<void*>(b.get()), a.get(), sizeof(Lanes));
    const int n = block % 2 == 0 ? kLanes : draw.count(kLanes);
    versions()[0](model_of(world), 1.0, 100.0, *a, n);
    versions()[1](model_of(world), 1.0, 100.0, *b, n);
    ASSERT_TRUE(std::ranges::equal(std::as_bytes(std::span(a.get(), 1)),
                                   std::as_bytes(std::span(b.get(), 1))))
        << "block " << block;
  }
}

/// Right over the radar, and as near as makes no difference.
TEST(LanesTest, NothingBreaksOverTheRadar) {
  const World world;
  for (const double offset_km : {0.0, 1e-300, 1e-160, 1e-12, 1e-9, 1e-6}) {
    const auto lanes = standing_at({{offset_km, 0.0}, {0.0, -offset_km}, {-offset_km, offset_km}});
    for (int lane = 0; lane < 3; ++lane) {
      for (const int variance : {0, 4, 7, 9}) lanes->p[variance][lane] = 0.01;
      set_interval(*lanes, lane, world, 1);
    }
    for (const PredictLanes version : versions()) {
      const auto after = std::make_unique<Lanes>(*lanes);
      version(model_of(world), 1.0, 100.0, *after, 3);
      for (int lane = 0; lane < 3; ++lane) {
        EXPECT_TRUE(std::isfinite(after->cost[lane]));
        EXPECT_TRUE(std::isfinite(after->range[lane]));
        EXPECT_LE(std::abs(after->bearing[lane]), pi);
        for (int i = 0; i < 10; ++i) EXPECT_TRUE(std::isfinite(after->updated[i][lane]));
        EXPECT_EQ(after->first_bucket[lane], 0);
      }
    }
  }
}

}  // namespace
}  // namespace mda::testing
