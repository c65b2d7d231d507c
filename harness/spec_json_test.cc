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
    const auto json = json_of(spec);
    EXPECT_EQ(json_of(spec_of(spec.name, json, "test")), json);
    EXPECT_NE(json, json_of(ScenarioSpec{}));
  }
}

TEST(SpecJsonTest, RefusesEveryAbsentOrWrongField) {
  const auto whole = json_of(ScenarioSpec{});
  for (const auto& [field, value] : whole.items()) {
    auto without = whole;
    without.erase(field);
    auto wrong = whole;
    wrong[field] =
        value.is_string() ? nlohmann::ordered_json("neither") : nlohmann::ordered_json("a word");
    for (const auto& bad : {without, wrong}) {
      try {
        static_cast<void>(spec_of("A", bad, "file.json"));
        ADD_FAILURE() << field;
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace mda
