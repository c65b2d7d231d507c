#include "scenarios/groups.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>
#include <string>

namespace mda::testing {
namespace {

TEST(GroupsTest, EveryNameFindsItsOwnEntry) {
  std::set<std::string> names;
  for (const ScenarioSpec& spec : scenario_list()) {
    EXPECT_EQ(find_scenario(spec.name), &spec);
    EXPECT_TRUE(names.insert(spec.name).second) << spec.name;
    EXPECT_FALSE(spec.summary.empty());
  }
  EXPECT_EQ(find_scenario("nothing of that name"), nullptr);
}

/// What Table 1 and section 4 give for all groups alike.
TEST(GroupsTest, CommonParameters) {
  for (const char* group : {"A", "B", "C", "D"}) {
    ASSERT_NE(find_scenario(group), nullptr);
    const World& world = find_scenario(group)->world;
    EXPECT_EQ(world.scans, 30);
    EXPECT_EQ(world.scan_period_s, 8.0);
    EXPECT_EQ(world.range_km, 50.0);
    EXPECT_EQ(find_scenario(group)->model.max_misses, 2);
    EXPECT_EQ(find_scenario(group)->model.gate, 9.21);
  }
}

/// What section IV gives for both scenarios, and for each.
TEST(GroupsTest, ParametersOfKnownTargets) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  for (const ScenarioSpec& spec : scenario_list()) {
    if (!spec.known_targets) continue;
    SCOPED_TRACE(spec.name);
    const bool first = spec.known_targets->trajectories == Trajectories::kPlatoons;
    EXPECT_EQ(spec.world.detection_probability, 0.8);
    EXPECT_EQ(spec.world.clutter_per_scan, 20.0);
    EXPECT_EQ(spec.known_targets->range_rate_sigma_km_s, 0.001);
    EXPECT_EQ(spec.world.scan_period_s, first ? 5.0 : 2.0);
    EXPECT_EQ(spec.world.range_sigma_km, first ? 0.015 : 0.05);
    EXPECT_NEAR(spec.world.bearing_sigma_rad, (first ? 0.25 : 0.5) * kDegree, 1e-15);
    EXPECT_EQ(spec.known_targets->normalisation, CostNormalisation::kClutterDensity);
    if (!spec.draws_as.empty()) {
      EXPECT_NE(find_scenario(spec.draws_as), nullptr);
      continue;
    }
    EXPECT_EQ(spec.known_targets->resolution_range_km, 0.05);
    EXPECT_NEAR(spec.known_targets->resolution_bearing_rad, kDegree, 1e-15);
  }
}

/// What section IV gives, and what we have fitted, for all scenes alike.
TEST(GroupsTest, ParametersOfPositionTargets) {
  int number = 0;
  for (const ScenarioSpec& spec : scenario_list()) {
    if (!spec.position_targets) continue;
    SCOPED_TRACE(spec.name);
    ++number;
    const PositionTargets& targets = *spec.position_targets;
    const bool ten = targets.scene == PositionScene::kTen;
    EXPECT_FALSE(spec.known_targets);
    EXPECT_EQ(spec.world.scans, 40);
    EXPECT_EQ(spec.world.scan_period_s, 1.0);
    EXPECT_EQ(spec.world.detection_probability, 0.7);
    EXPECT_EQ(spec.world.acceleration_sigma_km_s2, ten ? 0.01 : 0.005);
    EXPECT_EQ(spec.model.gate, 9.21);
    EXPECT_EQ(spec.model.update, TrackUpdate::kSoft);
    EXPECT_EQ(targets.duration_s, 40.0);
    EXPECT_EQ(targets.plot_sigma_km, 0.15);
    EXPECT_EQ(targets.clutter_spread_km, 0.5);
    EXPECT_EQ(targets.quiet_scans, 5);
    EXPECT_EQ(targets.manoeuvres == ManoeuvreModel::kSinger, ten);
    EXPECT_EQ(targets.clutter == ClutterLaw::kUniform,
              spec.name.find("-uniform") < spec.name.size());
    const auto at = spec.name.find("-c0.");
    const double density = at < spec.name.size() ? std::stod(spec.name.substr(at + 2)) : 0.2;
    EXPECT_EQ(targets.clutter_per_km2, density);
    const auto family = spec.name.substr(0, spec.name.find('-', 4));
    EXPECT_EQ(spec.draws_as, spec.name == family ? "" : family);
  }
  EXPECT_EQ(number, 18);
}

}  // namespace
}  // namespace mda::testing
