#include "harness/set_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/catalog.h"
#include "scenarios/world/draws.h"

namespace mda {
namespace {

using Positions = std::vector<Position>;

class SetDistanceTest : public ::testing::Test {
 protected:
  SetDistance distance(const Positions& truth, const Positions& estimates, double cut_off) {
    return set_distance(truth, estimates, cut_off, *assignment_);
  }

  /// Up to `most` positions in a square of 4 x 4.
  Positions random_positions(int most) {
    Positions positions(engine_() % static_cast<unsigned>(most + 1));
    for (Position& p : positions) p = {coordinate(), coordinate()};
    return positions;
  }

 private:
  double coordinate() { return 4.0 * std::ldexp(static_cast<double>(engine_() >> 11), -53); }

  std::unique_ptr<Associator> assignment_ = reference_algorithm().make();
  decltype(draws({})) engine_ = draws({.seed = 7, .scenario = "set distance"});
};

double squared(const Position& a, const Position& b) {
  return std::pow(a.x - b.x, 2) + std::pow(a.y - b.y, 2);
}

/// The definitions, over all ways to assign: the larger set is put into every order, and the first
/// of its members are matched with the smaller set.
struct ByDefinition {
  double gospa = 0.0;
  double ospa = 0.0;
};

ByDefinition by_definition(Positions a, Positions b, double c) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.empty()) return {};
  const auto extra = static_cast<double>(b.size() - a.size());
  std::vector<std::size_t> order(b.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  double least = INFINITY;
  do {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      sum += std::min(squared(a[i], b[order[i]]), c * c);
    }
    least = std::min(least, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return {std::sqrt(least + c * c / 2.0 * extra),
          std::sqrt((least + c * c * extra) / static_cast<double>(b.size()))};
}

TEST_F(SetDistanceTest, OfAWorkedExample) {
  // By hand: the pairs are 1, 2 and 5 apart (squared), the fourth true position is missed.
  const Positions truth = {{0, 0}, {10, 5}, {20, -5}, {100, 100}};
  const Positions estimates = {{1, 0}, {9, 6}, {22, -4}};
  const SetDistance d = distance(truth, estimates, 10.0);
  EXPECT_NEAR(d.localisation_squared, 8.0, 1e-12);
  EXPECT_NEAR(d.missed_squared, 50.0, 1e-12);
  EXPECT_EQ(d.false_squared, 0.0);
  EXPECT_NEAR(d.gospa, 7.61577310586, 1e-10);
}

TEST_F(SetDistanceTest, EqualsTheDefinitionOnSmallSets) {
  for (int i = 0; i < 300; ++i) {
    const Positions a = random_positions(5);
    const Positions b = random_positions(5);
    const SetDistance d = distance(a, b, 1.0);
    const ByDefinition expected = by_definition(a, b, 1.0);
    EXPECT_NEAR(d.gospa, expected.gospa, 1e-9);
    EXPECT_NEAR(d.ospa, expected.ospa, 1e-9);
    EXPECT_NEAR(d.localisation_squared + d.missed_squared + d.false_squared, d.gospa * d.gospa,
                1e-9);
  }
}

TEST_F(SetDistanceTest, IsAMetric) {
  for (int i = 0; i < 200; ++i) {
    const Positions a = random_positions(6);
    const Positions b = random_positions(6);
    const Positions c = random_positions(6);
    const SetDistance ab = distance(a, b, 1.5);
    const SetDistance ba = distance(b, a, 1.5);
    EXPECT_NEAR(distance(a, a, 1.5).gospa, 0.0, 1e-7);
    EXPECT_NEAR(ab.gospa, ba.gospa, 1e-9);
    EXPECT_NEAR(ab.missed_squared, ba.false_squared, 1e-9);
    EXPECT_LE(ab.gospa, distance(a, c, 1.5).gospa + distance(c, b, 1.5).gospa + 1e-9);
    EXPECT_LE(ab.ospa, distance(a, c, 1.5).ospa + distance(c, b, 1.5).ospa + 1e-9);
    EXPECT_LE(ab.ospa, 1.5 + 1e-12);
  }
}

TEST_F(SetDistanceTest, OfEmptySets) {
  const Positions two = {{0, 0}, {1, 1}};
  EXPECT_EQ(distance({}, {}, 1.0).gospa, 0.0);
  EXPECT_EQ(distance({}, {}, 1.0).ospa, 0.0);
  EXPECT_EQ(distance(two, {}, 1.0).missed_squared, 1.0);
  EXPECT_EQ(distance({}, two, 1.0).false_squared, 1.0);
  EXPECT_EQ(distance({}, two, 1.0).ospa, 1.0);
}

}  // namespace
}  // namespace mda
