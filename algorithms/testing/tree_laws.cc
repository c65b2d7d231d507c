#include "algorithms/testing/tree_laws.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace

void expect_lawful_tree(const AssociationProblem& problem) {
  const HypothesisTree& tree = problem.views()->tree;
  std::vector<int> node_of_column(index(problem.columns()), kNoNode);
  std::vector<char> leads_on(index(tree.nodes()), 0);
  for (int k = tree.scans(); k >= 0; --k) {
    for (int n = tree.layer_begin[index(k)]; n < tree.layer_begin[index(k) + 1]; ++n) {
      const int parent = tree.parent[index(n)];
      if (n > tree.layer_begin[index(k)] && parent != kNoNode) {
        EXPECT_LE(tree.parent[index(n) - 1], parent);
        EXPECT_NE(tree.parent[index(n) - 1], kNoNode) << "a birth before a continued track";
      }
      EXPECT_EQ(tree.column[index(n)] != kNoColumn, k == tree.scans());
      if (k == tree.scans()) {
        node_of_column[index(tree.column[index(n)])] = n;
        leads_on[index(n)] = 1;
      }
      EXPECT_TRUE(leads_on[index(n)]) << "a dead end";
      double until_then = 0.0;
      if (parent != kNoNode) {
        leads_on[index(parent)] = 1;
        EXPECT_GE(n, tree.child_begin[index(parent)]);
        EXPECT_LT(n, tree.child_end[index(parent)]);
        EXPECT_EQ(tree.track[index(n)], tree.track[index(parent)]);
        until_then = tree.cost[index(parent)];
      }
      EXPECT_NEAR(tree.cost[index(n)], until_then + tree.step[index(n)], 1e-12);
      if (tree.row[index(n)] != kNoRow) {
        EXPECT_EQ(problem.dimension(tree.row[index(n)]), k);
      }
    }
  }
  for (int j = 0; j < problem.columns(); ++j) {
    int n = node_of_column[index(j)];
    ASSERT_NE(n, kNoNode);
    EXPECT_NEAR(tree.cost[index(n)], problem.cost(j), 1e-12);
    std::set<int> rows;
    for (; n != kNoNode; n = tree.parent[index(n)]) {
      if (tree.row[index(n)] != kNoRow) rows.insert(tree.row[index(n)]);
    }
    EXPECT_EQ(rows, std::set<int>(problem.rows_of(j).begin(), problem.rows_of(j).end()));
  }
}

void expect_tuple_cost_of_columns(const AssociationProblem& problem, double tolerance) {
  const Views& views = *problem.views();
  const HypothesisTree& tree = views.tree;
  for (int leaf = tree.layer_begin[index(tree.scans())]; leaf < tree.nodes(); ++leaf) {
    Tuple tuple{tree.track[index(leaf)], std::vector<int>(index(tree.scans()), kNoRow)};
    int k = tree.scans();
    for (int n = leaf; tree.parent[index(n)] != kNoNode; n = tree.parent[index(n)]) {
      tuple.rows[index(--k)] = tree.row[index(n)];
    }
    EXPECT_NEAR(views.tuple_cost(tuple), problem.cost(tree.column[index(leaf)]), tolerance);
  }
}

}  // namespace mda::testing
