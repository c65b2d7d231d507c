#include "scenarios/known/references.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/groups.h"
#include "scenarios/hypotheses/track_forest.h"
#include "scenarios/testing/known.h"

namespace mda::testing {
namespace {

double mean_error_km(const StateHistory& states, const KnownScene& scene) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t scan = 0; scan < states.size(); ++scan) {
    for (std::size_t i = 0; i < states[scan].size(); ++i, count += 1.0) {
      sum += std::hypot(states[scan][i].x - scene.scans[scan].truth[i].x,
                        states[scan][i].y - scene.scans[scan].truth[i].y);
    }
  }
  return sum / count;
}

TEST(ReferencesTest, TheIdealIsNearTheTruthAndTheOracleNotBetter) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    SCOPED_TRACE(spec.name);
    double ideal = 0.0;
    double oracle = 0.0;
    for (int replicate = 1; replicate <= 5; ++replicate) {
      const KnownScene scene = simulate_known(spec, 1, replicate);
      ideal += mean_error_km(ideal_states(scene, spec), scene) / 5.0;
      oracle += mean_error_km(oracle_states(scene, spec), scene) / 5.0;
    }
    EXPECT_LT(ideal, 0.1);
    EXPECT_GT(oracle, ideal);
    EXPECT_LT(oracle, 0.3);
  }
}

TEST(ReferencesTest, WithNothingMissedOrMergedTheOracleIsTheIdeal) {
  ScenarioSpec spec = *find_scenario("battistelli-1");
  spec.world.detection_probability = 1.0;
  spec.known_targets->resolution_range_km = 0.0;
  const KnownScene scene = simulate_known(spec, 1, 1);
  const StateHistory ideal = ideal_states(scene, spec);
  const StateHistory oracle = oracle_states(scene, spec);
  ASSERT_EQ(ideal.size(), scene.scans.size());
  for (std::size_t scan = 0; scan < ideal.size(); ++scan) {
    ASSERT_EQ(ideal[scan].size(), scene.initial.size());
    for (std::size_t i = 0; i < ideal[scan].size(); ++i) {
      EXPECT_EQ(ideal[scan][i].x, oracle[scan][i].x);
      EXPECT_EQ(ideal[scan][i].vy, oracle[scan][i].vy);
    }
  }
}

/// Plot 0 is of targets 0 and 1, plot 1 of target 2, plot 2 clutter; target 3 is not detected.
class RightTest : public ::testing::Test {
 protected:
  [[nodiscard]] bool right(const std::vector<int>& plots, int target) const {
    return is_right(scan_, plots, target);
  }

  KnownScan scan_{.plots = {{10.0, 0.0, 0.0, {0, 1}}, {11.0, 0.0, 0.0, {2}}, {12.0, 0.0, 0.0, {}}},
                  .truth = std::vector<TargetState>(4),
                  .own = std::vector<DopplerPlot>(4),
                  .detected = {true, true, true, false}};
};

TEST_F(RightTest, APlotIsRightForItsSources) {
  EXPECT_TRUE(right({0, kNoPlot, 1, kNoPlot}, 0));
  EXPECT_TRUE(right({kNoPlot, 0, 1, kNoPlot}, 1));
  EXPECT_TRUE(right({0, kNoPlot, 1, kNoPlot}, 2));
  EXPECT_FALSE(right({1, 0, kNoPlot, kNoPlot}, 0));
  EXPECT_FALSE(right({2, kNoPlot, kNoPlot, kNoPlot}, 0));
  EXPECT_FALSE(right({0, kNoPlot, 1, 2}, 3));
}

TEST_F(RightTest, AMissIsRightIfThereIsNoPlotToTake) {
  EXPECT_TRUE(right({0, kNoPlot, 1, kNoPlot}, 3));
  EXPECT_TRUE(right({0, kNoPlot, 1, kNoPlot}, 1)) << "its merged plot went to another source";
  EXPECT_FALSE(right({kNoPlot, kNoPlot, 0, kNoPlot}, 1)) << "taken, but by no source of it";
  EXPECT_FALSE(right({2, kNoPlot, 1, kNoPlot}, 1)) << "the other source took another plot";
  EXPECT_FALSE(right({kNoPlot, kNoPlot, 1, kNoPlot}, 0));
  EXPECT_FALSE(right({0, kNoPlot, kNoPlot, kNoPlot}, 2));
}

}  // namespace
}  // namespace mda::testing
