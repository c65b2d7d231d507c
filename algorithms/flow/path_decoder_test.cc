#include "algorithms/flow/path_decoder.h"

#include <gtest/gtest.h>

#include <set>

#include "algorithms/testing/draw.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_trees.h"

namespace mda {
namespace {

using testing::cost_of;
using testing::Draw;
using testing::random_tree_problem;
using testing::random_tree_shape;
using testing::row_violation;
using testing::TreeShape;

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kWindows = 300;

int rows_of_dimension(const AssociationProblem& problem, int dimension, std::vector<int>& rows) {
  rows.clear();
  for (int r = 0; r < problem.rows(); ++r) {
    if (problem.dimension(r) == dimension) rows.push_back(r);
  }
  return static_cast<int>(rows.size());
}

/// Sequences for all tracks of the tree that share no plot.
std::vector<Tuple> random_sequences(const AssociationProblem& problem, std::uint64_t seed) {
  Draw draw(seed);
  const HypothesisTree& tree = problem.views()->tree;
  std::vector<Tuple> tuples(index(tree.layer_begin[1]));
  for (int t = 0; t < tree.layer_begin[1]; ++t) tuples[index(t)].track = tree.row[index(t)];
  std::vector<int> plots;
  for (int k = 1; k <= tree.scans(); ++k) {
    const int count = rows_of_dimension(problem, k, plots);
    const std::vector<int> order = draw.permutation(count);
    for (std::size_t t = 0; t < tuples.size(); ++t) {
      const bool missed = t >= order.size() || draw.chance(0.3);
      tuples[t].rows.push_back(missed ? kNoRow : plots[index(order[t])]);
    }
  }
  return tuples;
}

TEST(PathDecoder, SelectsTheColumnOfASequence) {
  for (std::uint64_t seed = 1; seed <= kWindows; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem =
        random_tree_problem(random_tree_shape(seed, seed % 2 == 0), seed);
    const HypothesisTree& tree = problem.views()->tree;
    for (int end = tree.layer_begin[index(tree.scans())]; end < tree.nodes(); ++end) {
      std::vector<int> rows(index(tree.scans()), kNoRow);
      int n = end;
      for (int k = tree.scans(); k >= 1 && n != kNoNode; --k, n = tree.parent[index(n)]) {
        rows[index(k) - 1] = tree.row[index(n)];
      }
      PathDecoder decoder(problem);
      const int track = tree.track[index(end)];
      if (track != kNoRow) {
        decoder.follow({track, rows});
      } else {
        decoder.begin(rows);
      }
      const Solution solution = decoder.answer();
      EXPECT_EQ(solution.x[index(tree.column[index(end)])], 1.0);
      EXPECT_EQ(cost_of(problem, solution), problem.cost(tree.column[index(end)]));
      EXPECT_EQ(solution.stats.off_column_paths, 0);
    }
  }
}

TEST(PathDecoder, AnswersOrRepairsWhatIsNoColumn) {
  int answered_as_tuples = 0;
  int repaired = 0;
  for (std::uint64_t seed = 1; seed <= kWindows; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = random_tree_shape(seed, false);
    shape.must_go_on = seed % 2 == 0;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    PathDecoder decoder(problem);
    std::set<int> offered;
    for (const Tuple& tuple : random_sequences(problem, seed)) {
      decoder.follow(tuple);
      offered.insert(tuple.track);
      offered.insert(tuple.rows.begin(), tuple.rows.end());
    }
    const Solution solution = decoder.answer();
    EXPECT_EQ(row_violation(problem, solution), 0.0);
    for (int j = 0; j < problem.columns(); ++j) {
      if (solution.x[index(j)] == 0.0) continue;
      for (const int r : problem.rows_of(j)) EXPECT_TRUE(offered.contains(r)) << r;
    }
    const int off = *solution.stats.off_column_paths;
    EXPECT_LE(static_cast<int>(solution.tuples.size()), off);
    if (shape.must_go_on) {
      EXPECT_EQ(static_cast<int>(solution.tuples.size()), off) << "tuple_cost is there";
      answered_as_tuples += off;
    } else {
      EXPECT_TRUE(solution.tuples.empty());
      repaired += off;
    }
  }
  EXPECT_GE(answered_as_tuples, 100);
  EXPECT_GE(repaired, 50);
}

TEST(PathDecoder, CoastingCostsWhatItSays) {
  for (std::uint64_t seed = 1; seed <= kWindows; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = random_tree_shape(seed, false);
    shape.must_go_on = seed % 2 == 0;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    const HypothesisTree& tree = problem.views()->tree;
    PathDecoder decoder(problem);
    double cost = 0.0;
    for (int t = 0; t < tree.layer_begin[1]; ++t) {
      decoder.coast(tree.row[index(t)]);
      cost += decoder.coasting_cost(tree.row[index(t)]);
      if (!shape.must_go_on) {
        EXPECT_LE(decoder.coasting_cost(tree.row[index(t)]), 0.0);
      }
    }
    const Solution solution = decoder.answer();
    EXPECT_EQ(row_violation(problem, solution), 0.0);
    EXPECT_NEAR(cost_of(problem, solution), cost, 1e-9);
  }
}

}  // namespace
}  // namespace mda
