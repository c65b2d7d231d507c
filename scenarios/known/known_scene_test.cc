#include "scenarios/known/known_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "scenarios/duration.h"
#include "scenarios/groups.h"
#include "scenarios/testing/known.h"

namespace mda {

// Found by argument-dependent lookup, so they stand beside what they compare.
static bool operator==(const DopplerPlot& a, const DopplerPlot& b) {
  return a.range_km == b.range_km && a.bearing_rad == b.bearing_rad &&
         a.range_rate_km_s == b.range_rate_km_s && a.sources == b.sources;
}
static bool operator==(const KnownScan& a, const KnownScan& b) {
  return a.plots == b.plots && a.own == b.own && a.detected == b.detected;
}

namespace testing {
namespace {

constexpr std::uint64_t kSeed = 1;

ScenarioSpec perfectly_resolved(ScenarioSpec spec) {
  spec.known_targets->resolution_range_km = 0.0;
  return spec;
}

TEST(KnownSceneTest, SameKeySameSceneOtherKeyOtherScene) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    SCOPED_TRACE(spec.name);
    const KnownScene scene = simulate_known(spec, kSeed, 2);
    EXPECT_EQ(simulate_known(spec, kSeed, 2).scans, scene.scans);
    EXPECT_NE(simulate_known(spec, kSeed, 3).scans, scene.scans);
    EXPECT_NE(simulate_known(spec, kSeed + 1, 2).scans, scene.scans);
    EXPECT_EQ(static_cast<int>(scene.scans.size()), spec.world.scans);
    EXPECT_EQ(scan_count(spec), spec.world.scans);
  }
}

TEST(KnownSceneTest, ScenariosThatDrawAsAnotherShareItsNoise) {
  int shared = 0;
  for (const ScenarioSpec& spec : known_scenarios()) {
    if (spec.draws_as.empty()) continue;
    ++shared;
    const KnownScene scene = simulate_known(spec, kSeed, 1);
    const KnownScene other = simulate_known(*find_scenario(spec.draws_as), kSeed, 1);
    ASSERT_EQ(scene.scans.size(), other.scans.size());
    for (std::size_t i = 0; i < scene.scans.size(); ++i) {
      EXPECT_EQ(scene.scans[i].own, other.scans[i].own);
      EXPECT_EQ(scene.scans[i].detected, other.scans[i].detected);
    }
    for (std::size_t i = 0; i < scene.initial.size(); ++i) {
      EXPECT_EQ(scene.initial[i].mean, other.initial[i].mean);
    }
    EXPECT_NE(scene.scans, other.scans) << "the resolution makes no difference";
  }
  EXPECT_EQ(shared, 3);
}

TEST(KnownSceneTest, AnotherScanPeriodLooksAtTheSameTrajectories) {
  for (const char* name : {"battistelli-1", "battistelli-2"}) {
    const ScenarioSpec& slow = *find_scenario(name);
    ScenarioSpec fast = slow;
    fast.world.scan_period_s = 0.5 * slow.world.scan_period_s;
    const KnownScene a = simulate_known(slow, kSeed, 1);
    const KnownScene b = simulate_known(fast, kSeed, 1);
    ASSERT_EQ(b.scans.size(), 2 * a.scans.size());
    for (std::size_t i = 0; i < a.initial.size(); ++i) {
      EXPECT_EQ(a.initial[i].mean, b.initial[i].mean);
    }
    for (std::size_t scan = 0; scan < a.scans.size(); ++scan) {
      for (std::size_t i = 0; i < a.initial.size(); ++i) {
        EXPECT_NEAR(a.scans[scan].truth[i].x, b.scans[2 * scan + 1].truth[i].x, 1e-12);
        EXPECT_NEAR(a.scans[scan].truth[i].y, b.scans[2 * scan + 1].truth[i].y, 1e-12);
      }
    }
  }
  ScenarioSpec broken = *find_scenario("battistelli-1");
  broken.world.scan_period_s = 7.0;
  EXPECT_EQ(scan_count(broken), 42);
  broken.world.scan_period_s = 0.1;
  EXPECT_EQ(scan_count(broken), 3000);
}

/// Mean square of the errors, in sigmas, and the share of detections.
TEST(KnownSceneTest, NoiseAndMissesAreAsStated) {
  const ScenarioSpec& spec = *find_scenario("battistelli-1");
  Eigen::Array3d squares = Eigen::Array3d::Zero();
  double detected = 0.0;
  double count = 0.0;
  for (int replicate = 1; replicate <= 5; ++replicate) {
    for (const KnownScan& scan : simulate_known(spec, kSeed, replicate).scans) {
      for (std::size_t i = 0; i < scan.truth.size(); ++i, count += 1.0) {
        const Eigen::Array3d error = measurement_of(scan.own[i]) - measured(scan.truth[i]);
        squares += (error / doppler_plot_covariance(spec).diagonal().array().sqrt()).square();
        detected += scan.detected[i] ? 1.0 : 0.0;
      }
    }
  }
  const double sigma = std::sqrt(2.0 / count);  // of a mean of squared standard normals
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(squares(i) / count, 1.0, 5.0 * sigma);
  EXPECT_NEAR(detected / count, 0.8, 5.0 * std::sqrt(0.8 * 0.2 / count));
}

TEST(KnownSceneTest, InitialEstimatesAreAroundTheTruthAtTimeZero) {
  const ScenarioSpec& spec = *find_scenario("battistelli-1");
  const std::vector<TargetState> truth = true_states(*spec.known_targets, 0.0);
  double d2 = 0.0;
  double count = 0.0;
  for (int replicate = 1; replicate <= 50; ++replicate) {
    const KnownScene scene = simulate_known(cut_short(spec, 1), kSeed, replicate);
    ASSERT_EQ(scene.initial.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i, count += 4.0) {
      const Eigen::Vector4d exact(truth[i].x, truth[i].vx, truth[i].y, truth[i].vy);
      const Eigen::Vector4d error = scene.initial[i].mean - exact;
      d2 += error.dot(scene.initial[i].covariance.ldlt().solve(error));
    }
  }
  EXPECT_NEAR(d2 / count, 1.0, 5.0 * std::sqrt(2.0 / count));
  const Gaussian first = simulate_known(spec, kSeed, 1).initial[0];
  EXPECT_NEAR(std::sqrt(first.covariance(0, 0)), 0.03, 1e-12);
  EXPECT_NEAR(std::sqrt(first.covariance(3, 3)), 0.003, 1e-12);
}

TEST(KnownSceneTest, TwentyPlotsOfClutterInTheBox) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    SCOPED_TRACE(spec.name);
    const KnownScene scene = simulate_known(perfectly_resolved(spec), kSeed, 1);
    const PlotBox& box = scene.clutter_box;
    for (const KnownScan& scan : scene.scans) {
      int clutter = 0;
      for (const DopplerPlot& plot : scan.plots) {
        if (!plot.sources.empty()) continue;
        ++clutter;
        EXPECT_TRUE(plot.range_km >= box.range_low_km && plot.range_km <= box.range_high_km);
        EXPECT_TRUE(plot.bearing_rad >= box.bearing_low_rad &&
                    plot.bearing_rad <= box.bearing_high_rad);
        EXPECT_TRUE(plot.range_rate_km_s >= box.range_rate_low_km_s &&
                    plot.range_rate_km_s <= box.range_rate_high_km_s);
      }
      EXPECT_EQ(clutter, 20);
    }
  }
}

TEST(KnownSceneTest, EveryDetectedTargetIsInOnePlotAndTheOthersInNone) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    for (const KnownScan& scan : simulate_known(spec, kSeed, 1).scans) {
      EXPECT_TRUE(std::ranges::is_sorted(scan.plots, {}, &DopplerPlot::range_km));
      std::multiset<int> seen;
      for (const DopplerPlot& plot : scan.plots) {
        EXPECT_TRUE(std::ranges::is_sorted(plot.sources));
        seen.insert(plot.sources.begin(), plot.sources.end());
      }
      for (std::size_t i = 0; i < scan.truth.size(); ++i) {
        EXPECT_EQ(seen.count(static_cast<int>(i)), scan.detected[i] ? 1U : 0U);
      }
    }
  }
}

TEST(KnownSceneTest, WithPerfectResolutionNothingIsMerged) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    const KnownScene scene = simulate_known(perfectly_resolved(spec), kSeed, 1);
    for (const KnownScan& scan : scene.scans) {
      for (const DopplerPlot& plot : scan.plots) {
        if (plot.sources.empty()) continue;
        ASSERT_EQ(plot.sources.size(), 1U);
        EXPECT_EQ(plot, scan.own[static_cast<std::size_t>(plot.sources[0])]);
      }
    }
  }
}

bool unresolved(const DopplerPlot& a, const DopplerPlot& b, const KnownTargets& targets) {
  return std::abs(a.range_km - b.range_km) < targets.resolution_range_km &&
         std::abs(a.bearing_rad - b.bearing_rad) < targets.resolution_bearing_rad;
}

/// The plots that can be reached from plot `from` over unresolved pairs.
std::set<std::size_t> reached(const std::vector<DopplerPlot>& plots, std::size_t from,
                              const KnownTargets& targets) {
  std::set<std::size_t> seen = {from};
  std::vector<std::size_t> open = {from};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (std::size_t i = 0; i < plots.size(); ++i) {
      if (unresolved(plots[at], plots[i], targets) && seen.insert(i).second) open.push_back(i);
    }
  }
  return seen;
}

TEST(KnownSceneTest, MergedPlotsAreTheMeansOfWhatChainsUp) {
  std::size_t largest = 0;
  for (const ScenarioSpec& spec : known_scenarios()) {
    const KnownTargets& targets = *spec.known_targets;
    for (const KnownScan& scan : simulate_known(perfectly_resolved(spec), kSeed, 1).scans) {
      const std::vector<DopplerPlot> merged = resolved(scan.plots, targets);
      std::set<std::set<std::size_t>> groups;
      for (std::size_t i = 0; i < scan.plots.size(); ++i) {
        groups.insert(reached(scan.plots, i, targets));
      }
      ASSERT_EQ(merged.size(), groups.size());
      for (const auto& group : groups) {
        largest = std::max(largest, group.size());
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        std::vector<int> sources;
        for (const std::size_t i : group) {
          sum += measurement_of(scan.plots[i]);
          sources.insert(sources.end(), scan.plots[i].sources.begin(), scan.plots[i].sources.end());
        }
        std::ranges::sort(sources);
        const Eigen::Vector3d mean = sum / static_cast<double>(group.size());
        EXPECT_TRUE(std::ranges::any_of(merged, [&](const DopplerPlot& plot) {
          return (measurement_of(plot) - mean).norm() < 1e-9 && plot.sources == sources;
        }));
      }
    }
  }
  EXPECT_GE(largest, 3U) << "no chain was put to the test";
}

TEST(KnownSceneTest, BearingsAreAveragedAcrossTheJump) {
  const double pi = std::numbers::pi;
  const auto merged =
      resolved({{10.0, pi - 0.002, 0.1, {0}}, {10.02, -pi + 0.004, 0.3, {1}}}, KnownTargets{});
  ASSERT_EQ(merged.size(), 1U);
  EXPECT_NEAR(merged[0].range_km, 10.01, 1e-12);
  EXPECT_NEAR(merged[0].bearing_rad, -pi + 0.001, 1e-12);
  EXPECT_NEAR(merged[0].range_rate_km_s, 0.2, 1e-12);
  EXPECT_EQ(merged[0].sources, (std::vector<int>{0, 1}));
}

TEST(KnownSceneTest, NeedsKnownTargets) {
  EXPECT_THROW(static_cast<void>(simulate_known(*find_scenario("A"), kSeed, 1)),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(scan_count(*find_scenario("A"))), std::invalid_argument);
}

}  // namespace
}  // namespace testing
}  // namespace mda
