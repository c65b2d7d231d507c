#include "scenarios/groups.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mda::testing
