#include "algorithms/multisensor/bojilov.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "algorithms/multisensor/thresholds.h"
#include "algorithms/testing/draw.h"
#include "algorithms/testing/random_sensors.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

using Matrix = std::vector<std::vector<double>>;
using Tuples = std::set<std::set<int>>;  ///< sets of rows

/// What the answer says, columns or not.
Tuples tuples_of(const AssociationProblem& problem, const BojilovOptions& options) {
  const Solution solution = make_bojilov(options)->solve(problem, Budget{});
  Tuples tuples;
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    if (solution.x[index(j)] == 1.0) tuples.emplace(rows.begin(), rows.end());
  }
  for (const Tuple& tuple : solution.tuples) {
    std::set<int> rows(tuple.rows.begin(), tuple.rows.end());
    rows.erase(kNoRow);
    tuples.insert(std::move(rows));
  }
  return tuples;
}

/// Two sensors with these distances and one without reports.
AssociationProblem two_sensors(const Matrix& a) {
  return sensor_problem({static_cast<int>(a.size()), static_cast<int>(a[0].size()), 0},
                        [&](int, int i, int, int j) { return a[index(i)][index(j)]; });
}

/// One report each.
AssociationProblem one_triple(double a12, double a13, double a23) {
  return sensor_problem({1, 1, 1}, [=](int s, int, int t, int) {
    return s + t == 1 ? a12 : s + t == 2 ? a13 : a23;
  });
}

/// Figure 1 of the paper: k, l are reports of one sensor, m, n of the other, Q = 9.21, Q* = 10.
///
///          m     n              m     n
///     k  13.2   6.3        k   10    6.3
///     l  35.7  11.8        l   10    10
///
/// The least sum of the plain terms is 13.2 + 11.8, of which neither is feasible.
TEST(BojilovTest, TheFragmentOfFigureOne) {
  const AssociationProblem problem = two_sensors({{13.2, 6.3}, {35.7, 11.8}});
  EXPECT_EQ(tuples_of(problem, {.q = 9.21, .q3 = 9.21}), Tuples{});
  EXPECT_EQ(tuples_of(problem, {.q = 9.21, .q3 = 9.21, .q_star = 10.0, .q3_star = 10.0}),
            (Tuples{{0, 3}}));
}

/// The least sum of A - price over any pairs that are feasible, found by trying everything.
double best_optional(const Matrix& a, double q, double price) {
  std::vector<char> used(a[0].size(), 0);
  const std::function<double(std::size_t)> from = [&](std::size_t i) {
    if (i == a.size()) return 0.0;
    double best = from(i + 1);
    for (std::size_t j = 0; j < used.size(); ++j) {
      if (used[j] != 0 || a[i][j] > q) continue;
      used[j] = 1;
      best = std::min(best, a[i][j] - price + from(i + 1));
      used[j] = 0;
    }
    return best;
  };
  return from(0);
}

TEST(BojilovTest, TreatmentIsOptionalAssignmentAtThePriceQStar) {
  Draw draw(1);
  for (int trial = 0; trial < 500; ++trial) {
    SCOPED_TRACE(trial);
    const int rows = 1 + draw.below(5);
    const int columns = 1 + draw.below(5);
    Matrix a(index(rows), std::vector<double>(index(columns)));
    for (auto& row : a) {
      for (double& value : row) value = 20.0 * draw.unit();
    }
    const double q = 2.0 + 10.0 * draw.unit();
    const double price = q * (1.0 + draw.unit());
    double sum = 0.0;
    for (const std::set<int>& pair :
         tuples_of(two_sensors(a), {.q = q, .q3 = q, .q_star = price, .q3_star = price})) {
      ASSERT_EQ(pair.size(), 2U);
      const double distance = a[index(*pair.begin())][index(*pair.rbegin() - rows)];
      EXPECT_LE(distance, q);
      sum += distance - price;
    }
    EXPECT_NEAR(sum, best_optional(a, q, price), 1e-9);
  }
}

/// A triple beyond Q, but not beyond a threshold of its own; and one beyond both.
TEST(BojilovTest, CalibratedTriples) {
  const Tuples whole = {{0, 1, 2}};
  EXPECT_EQ(tuples_of(one_triple(1.0, 4.0, 4.0), bojilov_options(0.01)), whole);
  EXPECT_EQ(tuples_of(one_triple(1.0, 6.0, 6.0), bojilov_options(0.01)), Tuples{});
  EXPECT_EQ(tuples_of(one_triple(1.0, 6.0, 6.0), calibrated_options(0.01)), whole);
  EXPECT_EQ(tuples_of(one_triple(1.0, 9.0, 9.0), calibrated_options(0.01)), (Tuples{{0, 1}}));
}

/// A good pair of the first two sensors, a single report of the first, and a report of the third
/// that fits nowhere: with the pair, step 4 excludes all of it.
TEST(BojilovTest, MisfitsGoToSinglesOrToPairs) {
  const AssociationProblem problem = sensor_problem(
      {2, 1, 1}, [](int s, int i, int t, int) { return s == 0 && i == 0 && t == 1 ? 1.0 : 100.0; });
  EXPECT_EQ(tuples_of(problem, bojilov_options(0.01)), (Tuples{{0, 2}}));
  EXPECT_EQ(tuples_of(problem, worst_ties_options(0.01)), Tuples{});
  EXPECT_EQ(tuples_of(problem, calibrated_options(0.01)), (Tuples{{0, 2}}));
}

/// Where everything is feasible and all sensors have as many reports, nothing is ever split.
TEST(BojilovTest, WithoutThresholdsItIsA3) {
  Draw draw(2);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 1 + draw.below(5);
    const AssociationProblem problem =
        sensor_problem({n, n, n}, [&](int, int, int, int) { return 4.0 * draw.unit(); });
    const Tuples a3 = tuples_of(problem, a3_options());
    EXPECT_EQ(a3.size(), index(n));
    EXPECT_EQ(tuples_of(problem, bojilov_options(0.01)), a3);
    EXPECT_EQ(tuples_of(problem, untreated_options(0.01)), a3);
    EXPECT_EQ(tuples_of(problem, calibrated_options(0.01)), a3);
  }
}

/// Two normal numbers of variance 1 (Box and Muller).
std::pair<double, double> normal_pair(Draw& draw) {
  const double radius = std::sqrt(-2.0 * std::log1p(-draw.unit()));
  const double angle = 2.0 * std::numbers::pi * draw.unit();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

TEST(ThresholdsTest, LoseWhatTheySayByMonteCarlo) {
  constexpr int kTriples = 1000000;
  EXPECT_NEAR(pair_threshold(0.01), 9.2103, 1e-4);
  EXPECT_NEAR(triple_threshold(0.01), 15.03, 5e-3);
  Draw draw(1);
  int beyond_q3 = 0;
  int beyond_q = 0;
  for (int trial = 0; trial < kTriples; ++trial) {
    const auto [x1, y1] = normal_pair(draw);
    const auto [x2, y2] = normal_pair(draw);
    const auto [x3, y3] = normal_pair(draw);
    const double a13 = (std::pow(x1 - x3, 2) + std::pow(y1 - y3, 2)) / 2.0;
    const double a23 = (std::pow(x2 - x3, 2) + std::pow(y2 - y3, 2)) / 2.0;
    beyond_q3 += a13 + a23 > 15.03 ? 1 : 0;
    beyond_q += a13 + a23 > 9.21 ? 1 : 0;
  }
  // Five standard errors: 0.0001 and 0.00025 each.
  EXPECT_NEAR(static_cast<double>(beyond_q3) / kTriples, 0.01, 5e-4);
  EXPECT_NEAR(static_cast<double>(beyond_q) / kTriples, 0.0695, 1.3e-3);
}

TEST(ThresholdsTest, AreInversesOfTheirLosses) {
  for (const double loss : {0.9, 0.2, 0.1, 0.025, 0.01, 1e-4, 1e-9}) {
    EXPECT_NEAR(triple_loss(triple_threshold(loss)) / loss, 1.0, 1e-12);
    EXPECT_GT(triple_threshold(loss), pair_threshold(loss));
  }
}

TEST(BojilovTest, SenselessThresholdsAreRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<BojilovOptions> bad = {{.q = 0.0, .q3 = 1.0},
                                           {.q = -1.0, .q3 = 1.0},
                                           {.q = kNan, .q3 = 1.0},
                                           {.q = 1.0, .q3 = 0.0},
                                           {.q = 9.0, .q3 = 9.0, .q_star = 8.0},
                                           {.q = 9.0, .q3 = 15.0, .q_star = 10.0, .q3_star = 12.0}};
  for (const BojilovOptions& options : bad) {
    EXPECT_THROW(static_cast<void>(make_bojilov(options)), std::invalid_argument);
  }
}

}  // namespace
}  // namespace mda::testing
