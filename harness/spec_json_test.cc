#include "harness/spec_json.h"

#include <gtest/gtest.h>

#include "harness/errors.h"
#include "scenarios/groups.h"

namespace mda {
namespace {

TEST(SpecJsonTest, ReadsBackWhatItWrote) {
  for (ScenarioSpec spec : scenario_list()) {
    spec.world.scan_period_s = 4.25;
    spec.world.target_life_scans = 7;
    spec.model.density = Density::kPolarUniform;
    spec.model.second_plot = SecondPlot::kConverted;
    spec.model.trailing_misses = TrailingMisses::kLiveOnly;
    spec.model.newborn = Newborn::kSinglePlot;
    spec.model.rows = RowRule::kEquality;
    spec.model.max_misses = 5;
    spec.draws_as = "another";
    if (spec.known_targets) spec.known_targets->normalisation = CostNormalisation::kLiteral;
    const auto json = json_of(spec);
    EXPECT_EQ(json_of(spec_of(spec.name, json, "test")), json);
    EXPECT_NE(json, json_of(ScenarioSpec{}));
  }
}

TEST(SpecJsonTest, ReadsBackKnownTargets) {
  for (const ScenarioSpec& spec : scenario_list()) {
    const ScenarioSpec back = spec_of(spec.name, json_of(spec), "test");
    EXPECT_EQ(back.draws_as, spec.draws_as);
    EXPECT_EQ(back.world.initial_targets, spec.world.initial_targets);
    ASSERT_EQ(back.known_targets.has_value(), spec.known_targets.has_value());
    ASSERT_EQ(back.three_sensors.has_value(), spec.three_sensors.has_value());
    if (!spec.known_targets) continue;
    EXPECT_EQ(back.known_targets->trajectories, spec.known_targets->trajectories);
    EXPECT_EQ(back.known_targets->duration_s, spec.known_targets->duration_s);
    EXPECT_EQ(back.known_targets->resolution_range_km, spec.known_targets->resolution_range_km);
  }
}

void expect_refusal(const nlohmann::ordered_json& bad, const std::string& field) {
  try {
    static_cast<void>(spec_of("A", bad, "file.json"));
    ADD_FAILURE() << field;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
  }
}

nlohmann::ordered_json wrong(const nlohmann::ordered_json& value) {
  return value.is_string() ? nlohmann::ordered_json("neither") : nlohmann::ordered_json("a word");
}

TEST(SpecJsonTest, RefusesEveryAbsentOrWrongField) {
  const auto whole = json_of(ScenarioSpec{});
  for (const auto& [field, value] : whole.items()) {
    auto without = whole;
    without.erase(field);
    expect_refusal(without, field);
    auto changed = whole;
    changed[field] = wrong(value);
    expect_refusal(changed, field);
  }
}

TEST(SpecJsonTest, ReadsBackPositionTargets) {
  int uniform = 0;
  for (ScenarioSpec spec : scenario_list()) {
    if (spec.position_targets) spec.model.update = TrackUpdate::kHard;
    const ScenarioSpec back = spec_of(spec.name, json_of(spec), "test");
    ASSERT_EQ(back.position_targets.has_value(), spec.position_targets.has_value());
    EXPECT_EQ(back.model.update, spec.model.update);
    if (!spec.position_targets) continue;
    EXPECT_EQ(back.position_targets->scene, spec.position_targets->scene);
    EXPECT_EQ(back.position_targets->clutter, spec.position_targets->clutter);
    EXPECT_EQ(back.position_targets->clutter_per_km2, spec.position_targets->clutter_per_km2);
    EXPECT_EQ(back.position_targets->manoeuvres, spec.position_targets->manoeuvres);
    uniform += spec.position_targets->clutter == ClutterLaw::kUniform ? 1 : 0;
  }
  EXPECT_EQ(uniform, 9);
}

TEST(SpecJsonTest, RefusesPositionsThatCannotBeDrawn) {
  ScenarioSpec spec;
  spec.position_targets.emplace();
  const auto whole = json_of(spec);
  const std::pair<const char*, double> wrong_values[] = {
      {"plot_sigma_km", 0.0},      {"plot_sigma_km", -1e-300}, {"area_side_km", 0.0},
      {"clutter_spread_km", -1.0}, {"singer_time_s", 0.0},     {"clutter_per_km2", -1.0},
      {"clutter_per_km2", 1e9},    {"quiet_scans", -1.0}};
  for (const auto& [field, value] : wrong_values) {
    auto changed = whole;
    if (whole["position_targets"][field].is_number_integer()) {
      changed["position_targets"][field] = static_cast<int>(value);
    } else {
      changed["position_targets"][field] = value;
    }
    expect_refusal(changed, field);
  }
}

TEST(SpecJsonTest, RefusesEveryAbsentOrWrongFieldOfOptionalParts) {
  ScenarioSpec spec;
  spec.known_targets.emplace();
  spec.position_targets.emplace();
  spec.three_sensors.emplace();
  spec.draws_as = "another";
  const auto whole = json_of(spec);
  for (const char* part : {"known_targets", "position_targets", "three_sensors"}) {
    for (const auto& [field, value] : whole[part].items()) {
      auto without = whole;
      without[part].erase(field);
      expect_refusal(without, field);
      auto changed = whole;
      changed[part][field] = wrong(value);
      expect_refusal(changed, field);
    }
  }
  for (const char* field : {"known_targets", "position_targets", "three_sensors", "draws_as"}) {
    auto changed = whole;
    changed[field] = 7;
    expect_refusal(changed, field);
  }
}

}  // namespace
}  // namespace mda
