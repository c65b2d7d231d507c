// The stages of the certified solver, each against the definition of what it promises. The laws of
// the catalogue are in contract_test.cc, certificates in harness/certificate_check_test.cc.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/certified/ascent.h"
#include "algorithms/certified/column_generation.h"
#include "algorithms/certified/cuts.h"
#include "algorithms/certified/enumeration.h"
#include "algorithms/certified/kernel_search.h"
#include "algorithms/certified/swap_search.h"
#include "algorithms/certified/testing/random_packings.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

TEST(PackingTest, CostsTheSameAsTheWindowUpToRounding) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_problem(random_shape(seed, 24), seed);
    if (!problem.shape().always_feasible) continue;
    const WindowPacking window = pack(problem);
    const double best = *optimum(problem);
    const Steps packed = optimum_of(window.packing);
    EXPECT_NEAR(window.nats(packed + window.charged), best, tolerance(problem));
    EXPECT_LE(window.bound_nats(packed), best);
  }
}

TEST(PackingTest, ColumnsOfATreeShareItsRoot) {
  for_each_packing([](const Packing& packing, Steps /*optimum*/) {
    for (int t = 0; t < packing.trees(); ++t) {
      for (int j = packing.tree_begin[index(t)]; j < packing.tree_begin[index(t) + 1]; ++j) {
        EXPECT_EQ(std::ranges::count(packing.rows_of(j), packing.root[index(t)]), 1);
      }
    }
  });
}

TEST(PricingTest, AnyPricesBoundTheOptimumAndFoldingKeepsTheBound) {
  for_each_packing([](const Packing& packing, Steps best) {
    std::vector<Steps> prices(index(packing.rows()));
    for (int r = 0; r < packing.rows(); ++r) {
      prices[index(r)] = -packing.cost[index(r % packing.columns())] / (2 + r % 3);
    }
    Pricing pricing;
    price(packing, prices, pricing);
    const Steps before = pricing.bound;
    EXPECT_LE(before, best);
    fold_into_roots(packing, prices, pricing);
    EXPECT_GE(pricing.bound, before);
    EXPECT_LE(pricing.bound, best);
    EXPECT_GE(std::ranges::min(pricing.reduced), 0);
  });
}

TEST(DualAscentTest, BoundAndChoiceHoldTheOptimumBetweenThem) {
  DualAscent ascent;
  for_each_packing([&](const Packing& packing, Steps best) {
    const AscentResult result = ascent.run(packing, Budget{});
    EXPECT_LE(result.bound, best);
    EXPECT_GE(result.cost, best);
    EXPECT_EQ(result.cost, cost_of(packing, result.choice));
    EXPECT_TRUE(is_choice(packing, result.choice));
    EXPECT_GE(std::ranges::min(result.prices), 0);
  });
}

TEST(SwapSearchTest, NeverLosesAndKeepsTheRows) {
  for_each_packing([](const Packing& packing, Steps best) {
    AscentResult ascent = DualAscent().run(packing, Budget{});
    Pricing pricing;
    fold_into_roots(packing, ascent.prices, pricing);
    SwapSearch swaps(packing, ascent.prices, pricing, ascent.cost - ascent.bound);
    swaps.start(ascent.choice);
    const Steps before = swaps.cost();
    EXPECT_LE(before, ascent.cost);
    swaps.improve(50, Budget{});
    EXPECT_LE(swaps.cost(), before);
    EXPECT_GE(swaps.cost(), best);
    EXPECT_EQ(swaps.cost(), cost_of(packing, swaps.choice()));
    EXPECT_TRUE(is_choice(packing, swaps.choice()));
  });
}

TEST(EnumerationTest, FindsTheOptimumBelowTheCeilingAndNothingElse) {
  for_each_packing([](const Packing& packing, Steps best) {
    AscentResult ascent = DualAscent().run(packing, Budget{});
    Pricing pricing;
    fold_into_roots(packing, ascent.prices, pricing);
    constexpr int kNoLimit = 10000000;
    const Enumeration found =
        enumerate(packing, ascent.prices, pricing, best + kGrid, kNoLimit, Budget{});
    ASSERT_TRUE(found.complete && found.choice);
    EXPECT_EQ(cost_of(packing, *found.choice), best);
    EXPECT_TRUE(is_choice(packing, *found.choice));
    const Enumeration nothing =
        enumerate(packing, ascent.prices, pricing, best, kNoLimit, Budget{});
    EXPECT_TRUE(nothing.complete && !nothing.choice);
    EXPECT_FALSE(enumerate(packing, ascent.prices, pricing, best + kGrid, 0, Budget{}).complete);
  });
}

TEST(ColumnGenerationTest, IsTheLpOfTheWholeProblem) {
  const auto lp = find_algorithm("lp")->make();
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = knot(seed);
    const WindowPacking window = pack(problem);
    const LpPoint point = solve_by_columns(
        window.packing, std::vector<Steps>(index(window.packing.rows()), 0), Budget{});
    ASSERT_EQ(point.outcome, Outcome::kOptimal);
    EXPECT_NEAR(window.nats(point.bound), lp->solve(problem, Budget{}).lower_bound,
                tolerance(problem));
  }
}

/// A cut that some choice breaks would make wrong optima, seldom enough to go unnoticed.
TEST(CutsTest, HoldForEveryChoiceAndNotForThePoint) {
  int cuts_seen = 0;
  for_each_packing([&](const Packing& packing, Steps /*best*/) {
    const std::vector<Steps> nothing(index(packing.rows()), 0);
    const LpPoint point = solve_by_columns(packing, nothing, Budget{});
    FractionalPoint fractional;
    for (const auto& entry : point.x) {
      if (entry.second < 1.0 - 1e-6) fractional.push_back(entry);
    }
    std::vector<double> x(packing.cost.size(), 0.0);
    for (const auto& [column, value] : fractional) x[index(column)] = value;
    const std::vector<char> alive(packing.cost.size(), 1);
    std::vector<Cut> cuts = odd_row_cuts(packing, alive, fractional, 40);
    std::ranges::move(clique_cuts(packing, alive, packing.cost, fractional, 20),
                      std::back_inserter(cuts));
    for (const Cut& cut : cuts) {
      ++cuts_seen;
      double used = 0.0;
      for (const auto& [column, coefficient] : cut.columns) used += coefficient * x[index(column)];
      EXPECT_GT(used, cut.right_hand_side);
      // The choice that uses most of the cut: an optimum for costs of minus its coefficients.
      ProblemBuilder builder;
      for (int r = 0; r < packing.rows(); ++r) builder.add_row(r, RowUse::kAtMostOnce);
      for (const auto& [column, coefficient] : cut.columns) {
        builder.add_column(-coefficient, packing.rows_of(column));
      }
      EXPECT_GE(*optimum(builder.build()), -cut.right_hand_side);
    }
  });
  EXPECT_GT(cuts_seen, 100);
}

TEST(KernelSearchTest, FindsTheOptimumBelowTheCeilingAndNothingElse) {
  int searched = 0;
  for_each_packing([&](const Packing& packing, Steps best) {
    const Part whole{.packing = packing,
                     .prices = std::vector<Steps>(index(packing.rows()), 0),
                     .bound = 2 * best,
                     .choice = {}};
    const Budget budget;
    Proof proof;
    const SearchResult found = KernelSearch(whole, 0, budget, proof).run();
    ASSERT_TRUE(found.complete && found.choice);
    EXPECT_EQ(cost_of(packing, *found.choice), best);
    EXPECT_EQ(found.floor, best);
    EXPECT_TRUE(is_choice(packing, *found.choice));
    const SearchResult nothing = KernelSearch(whole, best, budget, proof).run();
    EXPECT_TRUE(nothing.complete && !nothing.choice);
    searched += found.nodes > 1 ? 1 : 0;
  });
  EXPECT_GT(searched, 0) << "the packings are too easy to need a search";
}

/// Large enough for all stages: the same optimum as another solver, in any order of rows and
/// columns.
TEST(TreeExactTest, AgreesWithExactOnProblemsThatNeedSearch) {
  const auto tree_exact = find_algorithm("tree-exact")->make();
  const auto exact = find_algorithm("exact")->make();
  int searched = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    RandomShape shape;
    shape.dimensions = 3 + static_cast<int>(seed % 3);
    shape.rows_per_dimension = 14;
    shape.columns = 600;
    shape.presence = 0.9;
    shape.neighbourhood = 3 + static_cast<int>(seed % 4);
    shape.exactly_once = seed % 3 == 0 ? 0.5 : 0.0;
    shape.integer_costs = seed % 4 == 0;
    const AssociationProblem problem = random_problem(shape, seed);
    const Solution ours = tree_exact->solve(problem, Budget{});
    const Solution theirs = exact->solve(problem, Budget{});
    const Solution again = tree_exact->solve(reorder(problem, seed), Budget{});
    ASSERT_EQ(ours.status, Status::kOptimal);
    EXPECT_NEAR(cost_of(problem, ours), cost_of(problem, theirs), tolerance(problem));
    EXPECT_NEAR(ours.lower_bound, again.lower_bound, tolerance(problem));
    searched += ours.stats.nodes.value_or(0) > 3 ? 1 : 0;
  }
  EXPECT_GT(searched, 3);
}

/// 100,000 small windows, each in another order as well.
TEST(TreeExactTest, OrderDoesNotMatterOnManyWindows) {
  const auto tree_exact = find_algorithm("tree-exact")->make();
  for (std::uint64_t seed = 1; seed <= 100000; ++seed) {
    const AssociationProblem problem = random_problem(random_shape(seed, 24), seed);
    if (!problem.shape().always_feasible) continue;
    const AssociationProblem reordered = reorder(problem, seed);
    const double cost = cost_of(problem, tree_exact->solve(problem, Budget{}));
    const double again = cost_of(reordered, tree_exact->solve(reordered, Budget{}));
    ASSERT_NEAR(cost, again, tolerance(problem)) << seed;
  }
}

}  // namespace
}  // namespace mda::testing
