#include "scenarios/hypotheses/cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "scenarios/filter/ekf.h"
#include "scenarios/hypotheses/truth_cost.h"
#include "scenarios/testing/random_states.h"
#include "scenarios/testing/reference_forest.h"

namespace mda::testing {
namespace {

using std::numbers::pi;

World small_world() {
  World world;
  world.detection_probability = 0.8;
  world.births_per_scan = 0.7;
  world.clutter_per_scan = 3.0;
  world.range_km = 40.0;
  return world;
}

/// Scans of one target of 0.25 km/s: a plot, a plot, a miss, a plot, then misses.
std::vector<Scan> small_scene(int misses_at_the_end) {
  std::vector<Scan> scans(4);
  scans[0].plots = {plot_at(20.0, 0.5)};
  scans[1].plots = {plot_at(22.01, 0.502)};
  scans[3].plots = {plot_at(25.98, 0.497)};
  scans.resize(4 + static_cast<std::size_t>(misses_at_the_end));
  return scans;
}

/// A density of false alarms as printed in the paper, or turned into the units of f_delta.
double clutter_density(const World& world, Density density, double range_km) {
  const double per_km2 = 1.0 / (pi * world.range_km * world.range_km);
  switch (density) {
    case Density::kLiteral:
      return per_km2;
    case Density::kJacobian:
      return per_km2 * range_km;
    case Density::kPolarUniform:
      return 1.0 / (2.0 * pi) / world.range_km;
  }
  return 0.0;
}

/// f_delta of a plot around a predicted state.
double likelihood(const World& world, const Gaussian& predicted, const Plot& plot) {
  const Innovation expected = innovation(world, predicted);
  const Eigen::Vector2d nu = residual(expected, plot);
  return std::exp(-0.5 * nu.dot(expected.covariance.inverse() * nu)) /
         (2.0 * pi * std::sqrt(expected.covariance.determinant()));
}

/// Equation (6) for the small scene as one product of plain probabilities and densities.
double small_track_likelihood(const World& world, const TrackerModel& model,
                              int charged_misses_at_the_end) {
  const std::vector<Scan> scans = small_scene(0);
  const Plot& a = scans[0].plots[0];
  const Plot& b = scans[1].plots[0];
  const Plot& c = scans[3].plots[0];
  const auto clutter = [&](const Plot& plot) {
    return world.clutter_per_scan * clutter_density(world, model.density, plot.range_km);
  };
  const Gaussian before_b = predict(world, newborn_state(world, model, a));
  const Gaussian before_c = predict(world, predict(world, two_plot_state(world, model, a, b, 1)));
  const double p = world.detection_probability;
  const double birth = world.births_per_scan / world.clutter_per_scan;  // f_nu = f_phi
  const double second = p * likelihood(world, before_b, b) / clutter(b);
  const double third = p * likelihood(world, before_c, c) / clutter(c);
  return birth * second * (1.0 - p) * third * std::pow(1.0 - p, charged_misses_at_the_end);
}

/// The same track's cost from the terms.
double cost_by_terms(const World& world, const TrackerModel& model, int misses_at_the_end) {
  const CostTerms terms = cost_terms(world, model);
  const std::vector<Scan> scans = small_scene(0);
  Gaussian state = newborn_state(world, model, scans[0].plots[0]);
  double cost = terms.birth;
  for (std::size_t scan = 1; scan < scans.size(); ++scan) {
    state = predict(world, state);
    if (scans[scan].plots.empty()) {
      cost += terms.miss;
      continue;
    }
    const Plot& plot = scans[scan].plots[0];
    const Innovation expected = innovation(world, state);
    const Eigen::Vector2d nu = residual(expected, plot);
    cost += terms.detection + 0.5 * std::log(expected.covariance.determinant()) +
            0.5 * nu.dot(expected.covariance.inverse() * nu) +
            log_clutter_density(world, model, plot);
    state = scan == 1 ? two_plot_state(world, model, scans[0].plots[0], plot, 1)
                      : update(state, expected, plot);
  }
  const bool ended = misses_at_the_end > model.max_misses;
  return cost + misses_at_the_end * terms.miss -
         (ended ? terms.ended_discount : misses_at_the_end * terms.live_discount);
}

/// How many of the misses at the end are charged by the words of TrailingMisses, with p = 2.
int charged(TrailingMisses rule, int misses) {
  const bool ended = misses == 3;
  switch (rule) {
    case TrailingMisses::kAll:
      return misses;
    case TrailingMisses::kAllowed:
      return ended ? 2 : misses;
    case TrailingMisses::kLiveOnly:
      return ended ? 0 : misses;
    case TrailingMisses::kNone:
      break;
  }
  return 0;
}

class CostTest : public ::testing::TestWithParam<std::tuple<Density, TrailingMisses>> {};

TEST_P(CostTest, IsMinusTheLogarithmOfEquationSix) {
  const World world = small_world();
  TrackerModel model;
  std::tie(model.density, model.trailing_misses) = GetParam();
  for (int misses = 0; misses <= 3; ++misses) {
    const double q = small_track_likelihood(world, model, charged(model.trailing_misses, misses));
    EXPECT_NEAR(cost_by_terms(world, model, misses), -std::log(q), 1e-11) << misses << " misses";
  }
}

/// The oracle of the forest's tests, held to the same product.
TEST_P(CostTest, ReferenceForestCostsTheSame) {
  const World world = small_world();
  TrackerModel model;
  std::tie(model.density, model.trailing_misses) = GetParam();
  for (int misses = 0; misses <= 3; ++misses) {
    ReferenceForest forest(world, model, 20);
    for (const Scan& scan : small_scene(misses)) forest.grow(scan);
    const auto columns = forest.columns();
    const auto found = columns.find({{1, 0}, {2, 0}, {4, 0}});
    ASSERT_NE(found, columns.end());
    const double q = small_track_likelihood(world, model, charged(model.trailing_misses, misses));
    EXPECT_NEAR(found->second, -std::log(q), 1e-11) << misses << " misses";
  }
}

/// A target alone in the sky: the true tracks are this one.
TEST_P(CostTest, TruthCostsTheSame) {
  const World world = small_world();
  TrackerModel model;
  std::tie(model.density, model.trailing_misses) = GetParam();
  for (int misses = 0; misses <= 3; ++misses) {
    TruthCost truth;
    truth.reset(world, model);
    for (Scan scan : small_scene(misses)) {
      for (Plot& plot : scan.plots) plot.source = 0;
      truth.add(scan);
    }
    const double q = small_track_likelihood(world, model, charged(model.trailing_misses, misses));
    EXPECT_NEAR(truth.cost(), -std::log(q), 1e-11) << misses << " misses";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Alternatives, CostTest,
    ::testing::Combine(::testing::Values(Density::kLiteral, Density::kJacobian,
                                         Density::kPolarUniform),
                       ::testing::Values(TrailingMisses::kAll, TrailingMisses::kAllowed,
                                         TrailingMisses::kLiveOnly, TrailingMisses::kNone)));

/// The two densities that are densities in range and bearing integrate to 1 over the coverage.
TEST(ClutterDensityTest, IntegratesToOne) {
  const World world = small_world();
  for (const Density density : {Density::kJacobian, Density::kPolarUniform}) {
    TrackerModel model;
    model.density = density;
    constexpr int kSteps = 1000;
    double integral = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double range = (i + 0.5) * world.range_km / kSteps;
      integral += std::exp(log_clutter_density(world, model, plot_at(range, 1.0))) *
                  (world.range_km / kSteps) * 2.0 * pi;
    }
    EXPECT_NEAR(integral, 1.0, 1e-9);
  }
}

TEST(ClutterDensityTest, IsFiniteOverTheRadar) {
  TrackerModel model;
  for (const Density density : {Density::kLiteral, Density::kJacobian, Density::kPolarUniform}) {
    model.density = density;
    EXPECT_TRUE(std::isfinite(log_clutter_density(small_world(), model, plot_at(0.0, 0.0))));
  }
}

/// A track that ends leaves its cost behind, and the target's next plot starts another one.
TEST(TruthCostTest, StartsAnewAfterTooManyMisses) {
  const World world = small_world();
  const TrackerModel model;
  std::vector<Scan> scans = small_scene(3);
  const std::size_t once = scans.size();
  const std::vector<Scan> again = small_scene(0);
  scans.insert(scans.end(), again.begin(), again.end());
  TruthCost truth;
  truth.reset(world, model);
  double after_first = 0.0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for (Plot& plot : scans[i].plots) plot.source = 0;
    truth.add(scans[i]);
    if (i + 1 == once) after_first = truth.cost();
    if (i == once) {
      EXPECT_EQ(truth.cost(), after_first) << "one plot is no track yet";
    }
  }
  EXPECT_NEAR(after_first, -std::log(small_track_likelihood(world, model, 3)), 1e-11);
  EXPECT_NEAR(truth.cost() - after_first, -std::log(small_track_likelihood(world, model, 0)),
              1e-11);
}

}  // namespace
}  // namespace mda::testing
