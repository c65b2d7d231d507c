#include "scenarios/world/draws.h"

#include <gtest/gtest.h>

#include <vector>

namespace mda::testing {
namespace {

TEST(DrawsTest, EveryPartOfTheKeyCounts) {
  const DrawKey key{1, "A", 1, 1, Purpose::kBirths};
  std::vector<DrawKey> others(5, key);
  others[0].seed = 2;
  others[1].scenario = "B";
  others[2].replicate = 2;
  others[3].scan = 2;
  others[4].purpose = Purpose::kMotion;
  auto engine = draws(key);
  auto again = draws(key);
  const auto first = engine();
  EXPECT_EQ(again(), first);
  for (const DrawKey& other : others) EXPECT_NE(draws(other)(), first);
}

}  // namespace
}  // namespace mda::testing
