// The working set against the definition of what a row is worth to a tree.
#include "algorithms/certified/working_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "algorithms/certified/pricing.h"
#include "algorithms/testing/random_problems.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Few rows and trees of more columns than a word of a mask has bits.
Packing crowded(std::uint64_t seed) {
  RandomShape shape;
  shape.dimensions = 5;
  shape.rows_per_dimension = 3;
  shape.columns = 200 + static_cast<int>(seed % 5) * 200;
  shape.tracks = seed % 2 == 0;
  shape.presence = 0.7;
  shape.neighbourhood = shape.rows_per_dimension;
  shape.positive_share = 0.1;
  return pack(random_problem(shape, seed)).packing;
}

bool uses(const Packing& packing, int column, int row) {
  return std::ranges::count(packing.rows_of(column), row) > 0;
}

/// WorkingSet::worth from its definition.
Steps worth_of(const Packing& packing, const std::vector<Steps>& prices,
               const std::vector<char>& is_in, int tree, int row) {
  Steps with = std::numeric_limits<Steps>::max();
  Steps without = 0;
  for (int j = packing.tree_begin[index(tree)]; j < packing.tree_begin[index(tree) + 1]; ++j) {
    if (is_in[index(j)] == 0) continue;
    Steps reduced = packing.cost[index(j)];
    for (const int r : packing.rows_of(j)) reduced += prices[index(r)];
    Steps& least = uses(packing, j, row) ? with : without;
    least = std::min(least, reduced);
  }
  return without - with;
}

Links links_of(const Packing& packing) {
  Links links;
  LinkFinder().find(packing, links);
  return links;
}

TEST(LinksTest, AreThePairsOfTreesAndRows) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Packing packing = crowded(seed);
    const Links links = links_of(packing);
    int pairs = 0;
    for (int t = 0; t < packing.trees(); ++t) {
      std::vector<char> seen(index(packing.rows()), 0);
      for (int j = packing.tree_begin[index(t)]; j < packing.tree_begin[index(t) + 1]; ++j) {
        std::vector<int> rows;
        for (int n = links.node_of_column[index(j)]; n != Links::kTop;
             n = links.node[index(n)].parent) {
          EXPECT_GE(n, links.node_begin[index(t)]);
          EXPECT_LT(n, links.node_begin[index(t) + 1]);
          EXPECT_LT(links.node[index(n)].parent, n);
          const int link = links.node[index(n)].link;
          EXPECT_EQ(links.tree[index(link)], t);
          rows.insert(rows.begin(), links.row[index(link)]);
        }
        EXPECT_TRUE(std::ranges::equal(rows, packing.rows_of(j)));
        for (const int r : rows) pairs += std::exchange(seen[index(r)], 1) == 0 ? 1 : 0;
      }
    }
    EXPECT_EQ(links.count(), pairs);
    for (int r = 0; r < packing.rows(); ++r) {
      EXPECT_TRUE(std::ranges::is_sorted(links.of_row(r)));
      for (const int l : links.of_row(r)) EXPECT_EQ(links.row[index(l)], r);
    }
  }
}

/// Columns come in at random, prices move at random, and all that is asked is compared.
TEST(WorkingSetTest, KnowsWhatARowIsWorthToATree) {
  std::ptrdiff_t most_of_a_tree = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Packing packing = crowded(seed);
    const Links links = links_of(packing);
    WorkingSet set;
    set.start(packing, links);
    std::mt19937_64 random(seed);
    std::vector<Steps> prices(index(packing.rows()), 0);
    std::vector<char> is_in(packing.cost.size(), 0);
    Pricing pricing;
    const Steps scale = -std::ranges::min(packing.cost);
    for (int step = 0; step < 60; ++step) {
      price(packing, prices, pricing);
      const int tree = static_cast<int>(random() % index(packing.trees()));
      const Steps most = pricing.least[index(tree)] + static_cast<Steps>(random() % 8) * scale / 8;
      bool is_wider = false;
      for (int j = packing.tree_begin[index(tree)]; j < packing.tree_begin[index(tree) + 1]; ++j) {
        if (pricing.reduced[index(j)] > most || is_in[index(j)] != 0) continue;
        is_in[index(j)] = 1;
        is_wider = true;
      }
      EXPECT_EQ(set.widen(tree, pricing.reduced, most), is_wider);
      const int row = static_cast<int>(random() % index(packing.rows()));
      const Steps change = (static_cast<Steps>(random() % 201) - 100) * scale / 200;
      prices[index(row)] += change;
      for (const int l : set.links_of(row)) set.move(l, change);
      for (int r = 0; r < packing.rows(); ++r) {
        for (const int l : set.links_of(r)) {
          ASSERT_EQ(set.worth(l), worth_of(packing, prices, is_in, links.tree[index(l)], r));
        }
      }
      for (int t = 0; t < packing.trees(); ++t) {
        const auto columns = set.columns_of(t);
        for (std::size_t i = 0; i < columns.size(); ++i) {
          Steps expected = packing.cost[index(columns[i])];
          for (const int r : packing.rows_of(columns[i])) expected += prices[index(r)];
          EXPECT_EQ(set.reduced_of(t)[i], expected);
          EXPECT_NE(is_in[index(columns[i])], 0);
        }
      }
    }
    for (int t = 0; t < packing.trees(); ++t) {
      const auto first = is_in.begin() + packing.tree_begin[index(t)];
      const auto last = is_in.begin() + packing.tree_begin[index(t) + 1];
      most_of_a_tree = std::max(most_of_a_tree, std::count(first, last, 1));
    }
  }
  EXPECT_GT(most_of_a_tree, 64) << "no mask of several words";
}

}  // namespace
}  // namespace mda::testing
