#include "algorithms/marginal/hnpda.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "algorithms/testing/draw.h"
#include "algorithms/testing/random_pair_scans.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Sizes from nothing to crowds; costs of likely scans, or up to 700 nats either way.
AssociationProblem any_scan(std::uint64_t seed) {
  testing::Draw draw(seed);
  testing::PairScanShape shape;
  shape.tracks = draw.below(12);
  shape.plots = draw.below(16);
  shape.side_km = 0.2 + draw.unit();
  shape.must_go_on = draw.chance(0.5);
  AssociationProblem scan = testing::random_pair_scan(shape, seed);
  if (draw.chance(0.5)) return scan;
  ProblemBuilder builder;
  for (int r = 0; r < scan.rows(); ++r) builder.add_row(scan.dimension(r), scan.use(r));
  for (int j = 0; j < scan.columns(); ++j) {
    builder.add_column(1400.0 * (draw.unit() - 0.5), scan.rows_of(j));
  }
  return builder.build();
}

TEST(Hnpda, AnswersWithProbabilitiesWhateverTheSizeAndTheStep) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const AssociationProblem problem = any_scan(seed);
    for (const double step : {0.01, 0.3, 1.0, 3.0, 100.0}) {
      for (const bool normalised : {true, false}) {
        SCOPED_TRACE(::testing::Message() << seed << " " << step << " " << normalised);
        HnpdaOptions options;
        options.step = step;
        options.iterations = 300;
        options.normalised = normalised;
        const Solution solution = make_hnpda(options)->solve(problem, Budget{});
        std::vector<double> used(index(problem.rows()), 0.0);
        for (int j = 0; j < problem.columns(); ++j) {
          const double x = solution.x[index(j)];
          ASSERT_TRUE(x >= 0.0 && x <= 1.0) << x;
          for (const int r : problem.rows_of(j)) used[index(r)] += x;
        }
        for (int r = 0; r < problem.rows(); ++r) {
          if (problem.dimension(r) > 0) continue;
          EXPECT_LE(used[index(r)], 1.0 + 1e-9);
          if (problem.use(r) == RowUse::kExactlyOnce) {
            EXPECT_GE(used[index(r)], 1.0 - 1e-9);
          }
        }
      }
    }
  }
}

TEST(Hnpda, SettlesWithinItsStep) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const Solution solution = make_hnpda({})->solve(any_scan(seed), Budget{});
    EXPECT_EQ(solution.stop, Stop::kFinished);
  }
}

/// One track, m plots, every pair with its probability rho_j, j = 0 for none.
AssociationProblem one_track(const std::vector<double>& rho) {
  ProblemBuilder builder;
  builder.add_row(0, RowUse::kExactlyOnce);
  for (std::size_t j = 0; j < rho.size(); ++j) {
    std::vector<int> rows = {0};
    if (j > 0) rows.push_back(builder.add_row(1, RowUse::kAtMostOnce));
    builder.add_column(-std::log(rho[j]), rows);
  }
  return builder.build();
}

/// Without decay and rivals the limit solves a linear equation as long as it lies within (0, 1).
/// Summed over the m + 1 neurons it says S = (D + (m + 1) C) / (D + (m + 1) C + m B), and by itself
/// V_j = (C + D rho_j - (B + C) S) / (D - B).
TEST(Hnpda, ForOneTrackTheLimitIsTheSolutionOfALinearEquation) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    testing::Draw draw(seed);
    std::vector<double> rho(index(2 + draw.below(4)));
    for (double& value : rho) value = 0.5 + draw.unit();
    const double all = std::accumulate(rho.begin(), rho.end(), 0.0);
    for (double& value : rho) value /= all;
    for (const double gain_width : {0.02, 0.25, 1.0}) {
      SCOPED_TRACE(::testing::Message() << seed << " " << gain_width);
      HnpdaOptions options;
      options.decay = 0.0;
      options.gain_width = gain_width;
      options.tolerance = 1e-12;
      options.normalised = false;
      const double neurons = static_cast<double>(rho.size());
      const double plain = options.d + neurons * options.c;
      const double sum = plain / (plain + (neurons - 1.0) * options.b);
      const Solution raw = make_hnpda(options)->solve(one_track(rho), Budget{});
      options.normalised = true;
      const Solution solution = make_hnpda(options)->solve(one_track(rho), Budget{});
      for (std::size_t j = 0; j < rho.size(); ++j) {
        const double v = (options.c + options.d * rho[j] - (options.b + options.c) * sum) /
                         (options.d - options.b);
        ASSERT_TRUE(v > 0.0 && v < 1.0);
        EXPECT_NEAR(solution.x[j], v / sum, 1e-6);
        if (j > 0) {
          EXPECT_NEAR(raw.x[j], v, 1e-6);
        }
      }
    }
  }
}

/// Two tracks alike that want one plot: V_1 for it and V_0 for none solve
///     C + D rho_1 + E (1 - rho_1) = (A + C + D + E) V_1 + (B + C) V_0,
///     C + D rho_0 + E (1 - rho_0) = (C + D + E) V_0 + (B + C) V_1.
TEST(Hnpda, ForTwoTracksWithOnePlotTheLimitIsTheSolutionOfALinearEquation) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    testing::Draw draw(seed);
    HnpdaOptions options;
    options.a = 100.0 * draw.unit();
    options.d = 2000.0 * draw.unit();
    options.decay = 0.0;
    options.tolerance = 1e-12;
    options.normalised = false;
    const double rho = 0.2 + 0.6 * draw.unit();
    ProblemBuilder builder;
    for (int r = 0; r < 3; ++r) {
      builder.add_row(r / 2, r < 2 ? RowUse::kExactlyOnce : RowUse::kAtMostOnce);
    }
    for (int t = 0; t < 2; ++t) {
      builder.add_column(-std::log(1.0 - rho), std::vector{t});
      builder.add_column(-std::log(rho), std::vector{t, 2});
    }
    const Solution solution = make_hnpda(options)->solve(builder.build(), Budget{});
    const double given_1 = options.c + options.d * rho + options.e * (1.0 - rho);
    const double given_0 = options.c + options.d * (1.0 - rho) + options.e * rho;
    const double own_0 = options.c + options.d + options.e;
    const double own_1 = own_0 + options.a;
    const double cross = options.b + options.c;
    const double v_1 = (given_1 * own_0 - given_0 * cross) / (own_1 * own_0 - cross * cross);
    EXPECT_NEAR(solution.x[1], v_1, 1e-6);
    EXPECT_NEAR(solution.x[3], v_1, 1e-6);
  }
}

/// The network's own flaw: a plot that only one of two tracks wants is drawn to that track by E,
/// the more so the less likely it is.
TEST(Hnpda, DrawsATrackToThePlotNobodyElseWants) {
  ProblemBuilder builder;
  builder.add_row(0, RowUse::kExactlyOnce);
  builder.add_row(0, RowUse::kExactlyOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_column(0.0, std::vector{0});
  builder.add_column(0.0, std::vector{1});
  builder.add_column(-2.0, std::vector{0, 2});
  builder.add_column(-2.0, std::vector{1, 2});
  builder.add_column(2.0, std::vector{1, 3});
  const AssociationProblem problem = builder.build();
  HnpdaOptions options;
  const double with = make_hnpda(options)->solve(problem, Budget{}).x[4];
  options.e = 0.0;
  const double without = make_hnpda(options)->solve(problem, Budget{}).x[4];
  EXPECT_GT(with, without + 0.1);
}

}  // namespace
}  // namespace mda
