#include "algorithms/heuristic/greedy.h"

#include <gtest/gtest.h>

#include <vector>

#include "algorithms/testing/tiny_problems.h"

namespace mda::testing {
namespace {

std::vector<double> greedy_choice(const char* name) {
  return make_greedy()->solve(tiny_problem(name).problem, Budget{}).x;
}

/// By cost alone it would continue the track; what counts is the gain over coasting.
TEST(GreedyTest, RanksByTheGainOverCoasting) {
  EXPECT_EQ(greedy_choice("coasting track"), (std::vector{1.0, 0.0, 1.0}));
}

TEST(GreedyTest, FallsIntoTheTrap) {
  EXPECT_EQ(greedy_choice("greedy trap"), (std::vector{1.0, 0.0, 0.0}));
}

TEST(GreedyTest, FillsEveryExactlyOnceRow) {
  EXPECT_EQ(greedy_choice("rivals for a plot"), (std::vector{1.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(greedy_choice("must go on"), (std::vector{0.0, 1.0}));
}

}  // namespace
}  // namespace mda::testing
