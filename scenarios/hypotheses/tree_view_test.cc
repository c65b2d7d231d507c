#include "scenarios/hypotheses/tree_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "scenarios/groups.h"
#include "scenarios/testing/choices.h"
#include "scenarios/world/simulate.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Rows on the path to a node.
std::set<int> rows_to(const HypothesisTree& tree, int node) {
  std::set<int> rows;
  for (int n = node; n != kNoNode; n = tree.parent[index(n)]) {
    if (tree.row[index(n)] != kNoRow) rows.insert(tree.row[index(n)]);
  }
  return rows;
}

void expect_tree_of_columns(const WindowInstance& window, const HypothesisTree& tree) {
  const AssociationProblem& problem = window.problem;
  ASSERT_EQ(tree.scans() + 2, std::ssize(tree.layer_begin));
  const int first_leaf = tree.layer_begin[index(tree.scans())];
  ASSERT_EQ(tree.nodes() - first_leaf, problem.columns());
  for (int n = first_leaf; n < tree.nodes(); ++n) {
    const int column = tree.column[index(n)];
    EXPECT_EQ(tree.cost[index(n)], problem.cost(column));
    const auto rows = problem.rows_of(column);
    EXPECT_EQ(rows_to(tree, n), std::set<int>(rows.begin(), rows.end()));
  }
  for (int n = 0; n < tree.nodes(); ++n) {
    const int parent = tree.parent[index(n)];
    const double before = parent == kNoNode ? 0.0 : tree.cost[index(parent)];
    EXPECT_NEAR(tree.step[index(n)], tree.cost[index(n)] - before, 1e-12);
    if (n < first_leaf) {
      EXPECT_LT(tree.child_begin[index(n)], tree.child_end[index(n)]) << "a dead end";
    }
    for (int c = tree.child_begin[index(n)]; c < tree.child_end[index(n)]; ++c) {
      EXPECT_EQ(tree.parent[index(c)], n);
      EXPECT_EQ(tree.track[index(c)], tree.track[index(n)]);
    }
  }
}

TEST(TreeView, LeadsToEveryColumnOfEveryWindow) {
  for (const char* name : {"A", "C", "D"}) {
    for (const int k : {1, 3, 4}) {
      SCOPED_TRACE(std::string(name) + ", K = " + std::to_string(k));
      const ScenarioSpec& spec = *find_scenario(name);
      const Scene scene = simulate(spec, 1, 1);
      TrackForest forest;
      forest.reset(spec.world, spec.model, k, true);
      WindowExtractor extractor;
      for (int scan = 1; scan <= 12; ++scan) {
        forest.grow(scene.scans[index(scan) - 1]);
        const WindowInstance window = extractor.extract(forest);
        expect_tree_of_columns(window, tree_of(forest, window));
        if (HasFatalFailure()) return;
        forest.decide(leaves_of(window, cheapest_that_fit(window.problem)));
      }
    }
  }
}

}  // namespace
}  // namespace mda::testing
