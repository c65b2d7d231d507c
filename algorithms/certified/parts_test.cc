// What falls apart is put together again: parts and recombination.
#include "algorithms/certified/parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "algorithms/certified/ascent.h"
#include "algorithms/certified/recombination.h"
#include "algorithms/certified/swap_search.h"
#include "algorithms/certified/testing/random_packings.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

TEST(PartsTest, BoundsAndOptimaOfThePartsAddUp) {
  for_each_packing([](const Packing& packing, Steps best) {
    AscentResult ascent = DualAscent().run(packing, Budget{});
    Pricing pricing;
    fold_into_roots(packing, ascent.prices, pricing);
    const auto parts = parts_of(packing, ascent.prices, alive_columns(pricing, best + kGrid));
    Steps bound = 0;
    Steps optimum = 0;
    for (const Part& part : parts) {
      bound += part.bound;
      optimum += optimum_of(part.packing);
    }
    EXPECT_GE(bound, pricing.bound);
    EXPECT_EQ(optimum, best) << "a column of the optimum was ruled out";
  });
}

/// Every column that may be in a better choice is in one part with all its rows, and what is
/// settled is a choice that costs its bound.
TEST(PartsTest, WhatTheChoiceHasForItsBoundIsSettled) {
  int settled = 0;
  for_each_packing([&](const Packing& packing, Steps best) {
    const AscentResult ascent = DualAscent().run(packing, Budget{});
    std::vector<Steps> prices = ascent.prices;
    Pricing pricing;
    fold_into_roots(packing, prices, pricing);
    const Steps ceiling = best + kGrid;
    const auto parts = parts_beyond(packing, prices, pricing, ceiling, ascent.choice);
    ASSERT_TRUE(!parts.empty() && parts[0].choice);
    std::vector<int> columns;  // of the packing
    for (int j = 0; j < packing.columns(); ++j) {
      if (std::ranges::count(*parts[0].choice, packing.origin[index(j)]) > 0) columns.push_back(j);
    }
    EXPECT_EQ(columns.size(), parts[0].choice->size());
    EXPECT_TRUE(is_choice(packing, columns));
    EXPECT_EQ(cost_of(packing, columns), parts[0].bound);
    settled += columns.empty() ? 0 : 1;
    Steps optimum = parts[0].bound;
    for (const Part& part : std::span(parts).subspan(1)) {
      EXPECT_FALSE(part.choice);
      optimum += optimum_of(part.packing);
    }
    EXPECT_EQ(optimum, best);
  });
  EXPECT_GT(settled, 50) << "nothing was put to the test";
}

/// The columns of two choices and every third of the others, against the optimum of those alone.
TEST(RecombinationTest, IsTheOptimumOfTheColumnsThatItMayUse) {
  for_each_packing([](const Packing& packing, Steps /*best*/) {
    AscentResult ascent = DualAscent().run(packing, Budget{});
    Pricing pricing;
    fold_into_roots(packing, ascent.prices, pricing);
    SwapSearch swaps(packing, ascent.prices, pricing, ascent.cost - ascent.bound);
    swaps.start(std::vector<int>{packing.columns() - 1});
    const std::vector<std::vector<int>> choices = {ascent.choice, swaps.choice()};
    std::vector<char> alive(packing.cost.size(), 0);
    for (std::size_t j = 0; j < alive.size(); j += 3) alive[j] = 1;
    for (const auto& choice : choices) {
      for (const int j : choice) alive[index(j)] = 1;
    }
    const std::vector<int> found = recombined(packing, ascent.prices, alive, choices, Budget{});
    EXPECT_TRUE(is_choice(packing, found));
    EXPECT_TRUE(std::ranges::all_of(found, [&](int j) { return alive[index(j)] != 0; }));
    Steps optimum = 0;
    for (const Part& part : parts_of(packing, ascent.prices, alive)) {
      optimum += optimum_of(part.packing);
    }
    EXPECT_EQ(cost_of(packing, found), optimum);
    const Budget none{.deadline = Clock::time_point::min()};
    const Steps in_haste =
        cost_of(packing, recombined(packing, ascent.prices, alive, choices, none));
    EXPECT_LE(in_haste, std::min(ascent.cost, swaps.cost()));
  });
}

}  // namespace
}  // namespace mda::testing
