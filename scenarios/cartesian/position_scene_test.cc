#include "scenarios/cartesian/position_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

#include "scenarios/groups.h"
#include "scenarios/testing/positions.h"

namespace mda {

// Found by argument-dependent lookup, so they stand beside what they compare.
static bool operator==(const PositionPlot& a, const PositionPlot& b) {
  return a.position == b.position && a.source == b.source;
}
static bool operator==(const PositionScan& a, const PositionScan& b) { return a.plots == b.plots; }

namespace testing {
namespace {

constexpr std::uint64_t kSeed = 1;

TEST(PositionSceneTest, SameKeySameSceneOtherKeyOtherScene) {
  for (const ScenarioSpec& spec : position_scenarios()) {
    SCOPED_TRACE(spec.name);
    const PositionRun run = simulate_positions(spec, kSeed, 2);
    EXPECT_EQ(std::ssize(run.scans), 40);
    EXPECT_EQ(simulate_positions(spec, kSeed, 2).scans, run.scans);
    EXPECT_NE(simulate_positions(spec, kSeed, 3).scans, run.scans);
    EXPECT_NE(simulate_positions(spec, kSeed + 1, 2).scans, run.scans);
  }
}

TEST(PositionSceneTest, OneSceneHasTheSameNoiseUnderAnyClutter) {
  int shared = 0;
  for (const ScenarioSpec& spec : position_scenarios()) {
    if (spec.draws_as.empty()) continue;
    SCOPED_TRACE(spec.name);
    ++shared;
    const PositionRun run = simulate_positions(spec, kSeed, 1);
    const PositionRun other = simulate_positions(*find_scenario(spec.draws_as), kSeed, 1);
    for (std::size_t i = 0; i < run.scans.size(); ++i) {
      EXPECT_EQ(run.scans[i].own, other.scans[i].own);
      EXPECT_EQ(run.scans[i].detected, other.scans[i].detected);
    }
    EXPECT_EQ(run.looks[1].before, other.looks[1].before);
    EXPECT_NE(run.scans, other.scans) << "the clutter is the same, too";
  }
  EXPECT_EQ(shared, 15);
}

TEST(PositionSceneTest, PlotsAreTheDetectedTargetsAndClutterInNoTellingOrder) {
  for (const ScenarioSpec& spec : position_scenarios()) {
    SCOPED_TRACE(spec.name);
    for (const PositionScan& scan : simulate_positions(spec, kSeed, 1).scans) {
      EXPECT_TRUE(std::ranges::is_sorted(
          scan.plots, {}, [](const PositionPlot& plot) { return plot.position.x(); }));
      std::multiset<int> seen;
      for (const PositionPlot& plot : scan.plots) {
        if (plot.source == kFalseAlarm) continue;
        seen.insert(plot.source);
        EXPECT_EQ(plot.position, scan.own[static_cast<std::size_t>(plot.source)]);
      }
      for (std::size_t i = 0; i < scan.truth.size(); ++i) {
        EXPECT_EQ(seen.count(static_cast<int>(i)), scan.detected[i] ? 1U : 0U);
      }
    }
  }
}

TEST(PositionSceneTest, TheFirstScansAreQuiet) {
  for (const ScenarioSpec& spec : position_scenarios()) {
    SCOPED_TRACE(spec.name);
    std::size_t later = 0;
    for (int replicate = 1; replicate <= 10; ++replicate) {
      const PositionRun run = simulate_positions(spec, kSeed, replicate);
      for (std::size_t i = 0; i < run.scans.size(); ++i) {
        const PositionScan& scan = run.scans[i];
        const auto clutter = std::ranges::count(scan.plots, kFalseAlarm, &PositionPlot::source);
        if (i >= 5) later += static_cast<std::size_t>(clutter);
        if (i >= 5) continue;
        EXPECT_EQ(clutter, 0);
        EXPECT_EQ(scan.plots.size(), scan.truth.size());
      }
    }
    EXPECT_GT(later, 0U);
  }
}

/// Mean squares of the errors in plots and looks, in sigmas, and the share of detections.
TEST(PositionSceneTest, NoiseAndMissesAreAsStated) {
  const ScenarioSpec& spec = *find_scenario("lee-ten");
  double squares = 0.0;
  double errors = 0.0;
  double detected = 0.0;
  double chances = 0.0;
  const auto add = [&](const Eigen::Vector2d& plot, const TargetState& truth) {
    squares += (plot - Eigen::Vector2d(truth.x, truth.y)).squaredNorm() / (0.15 * 0.15);
    errors += 2.0;
  };
  for (int replicate = 1; replicate <= 10; ++replicate) {
    const PositionRun run = simulate_positions(spec, kSeed, replicate);
    for (std::size_t scan = 0; scan < run.scans.size(); ++scan) {
      const PositionScan& now = run.scans[scan];
      for (std::size_t i = 0; i < now.truth.size(); ++i) {
        add(now.own[i], now.truth[i]);
        if (scan < 5) continue;
        detected += now.detected[i] ? 1.0 : 0.0;
        chances += 1.0;
      }
    }
  }
  EXPECT_NEAR(squares / errors, 1.0, 5.0 * std::sqrt(2.0 / errors));
  EXPECT_NEAR(detected / chances, 0.7, 5.0 * std::sqrt(0.7 * 0.3 / chances));
}

/// Clutter plots for which `counts` holds, in all scans that are not quiet.
template <typename Counts>
double clutter_plots(const ScenarioSpec& spec, int replicates, Counts counts) {
  double number = 0.0;
  for (int replicate = 1; replicate <= replicates; ++replicate) {
    const PositionRun run = simulate_positions(spec, kSeed, replicate);
    for (std::size_t scan = 5; scan < run.scans.size(); ++scan) {
      for (const PositionPlot& plot : run.scans[scan].plots) {
        if (plot.source == kFalseAlarm && counts(run.scans[scan], plot.position)) number += 1.0;
      }
    }
  }
  return number;
}

void expect_poisson(double number, double mean) {
  EXPECT_NEAR(number, mean, 5.0 * std::sqrt(mean));
}

TEST(PositionSceneTest, ClutterIsPoissonOfItsMean) {
  for (const ScenarioSpec& spec : position_scenarios()) {
    SCOPED_TRACE(spec.name);
    const double mean = mean_clutter(*spec.position_targets);
    EXPECT_EQ(spec.world.clutter_per_scan, mean);
    constexpr int kRuns = 20;
    expect_poisson(clutter_plots(spec, kRuns, [](const auto&, const auto&) { return true; }),
                   mean * 35 * kRuns);
  }
}

TEST(PositionSceneTest, UniformClutterHasItsDensityEverywhere) {
  constexpr int kRuns = 20;
  for (const char* name : {"lee-crossing-uniform", "lee-parallel-uniform-c0.8"}) {
    SCOPED_TRACE(name);
    const ScenarioSpec& spec = *find_scenario(name);
    const double per_km2 = spec.position_targets->clutter_per_km2;
    for (const double x : {-10.0, -5.0, 0.0, 5.0}) {
      for (const double y : {-10.0, -5.0, 0.0, 5.0}) {
        expect_poisson(clutter_plots(spec, kRuns,
                                     [=](const auto&, const Eigen::Vector2d& at) {
                                       return at.x() >= x && at.x() < x + 5.0 && at.y() >= y &&
                                              at.y() < y + 5.0;
                                     }),
                       per_km2 * 25.0 * 35 * kRuns);
      }
    }
    EXPECT_EQ(clutter_plots(spec, kRuns,
                            [](const auto&, const Eigen::Vector2d& at) {
                              return at.cwiseAbs().maxCoeff() > 10.0;
                            }),
              0.0);
  }
}

/// Target 10 keeps away from all others, so the plots near it are of its own cloud: within r of
/// the centre, density x 2 pi s^2 (1 - exp(-r^2 / 2 s^2)), which is density x area for small r.
TEST(PositionSceneTest, ACloudHasItsDensityInItsCentre) {
  constexpr int kRuns = 200;
  const ScenarioSpec& spec = *find_scenario("lee-ten");
  const double s = 0.5;
  for (const double r : {0.2, 0.5, 1.0}) {
    SCOPED_TRACE(r);
    const double share = 1.0 - std::exp(-r * r / (2.0 * s * s));
    expect_poisson(clutter_plots(spec, kRuns,
                                 [=](const PositionScan& scan, const Eigen::Vector2d& at) {
                                   return std::hypot(at.x() - scan.truth[9].x,
                                                     at.y() - scan.truth[9].y) < r;
                                 }),
                   0.2 * 2.0 * std::numbers::pi * s * s * share * 35 * kRuns);
  }
}

TEST(PositionSceneTest, NeedsPositionTargets) {
  EXPECT_THROW(static_cast<void>(simulate_positions(*find_scenario("A"), kSeed, 1)),
               std::invalid_argument);
}

}  // namespace
}  // namespace testing
}  // namespace mda
