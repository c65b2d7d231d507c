// The referee's word on sequences beside the columns, and on ranked choices.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "algorithms/testing/random_trees.h"
#include "harness/referee.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Two tracks that must go on, two scans of two plots.
AssociationProblem known_tracks() {
  TreeShape shape;
  shape.tracks = 2;
  shape.scans = 2;
  shape.plots = 2;
  return random_tree_problem(shape, 7);
}

Tuple sequence(const AssociationProblem& problem, int leaf) {
  const HypothesisTree& tree = problem.views()->tree;
  Tuple tuple{tree.track[index(leaf)], std::vector<int>(index(tree.scans()), kNoRow)};
  int k = tree.scans();
  for (int n = leaf; tree.parent[index(n)] != kNoNode; n = tree.parent[index(n)]) {
    tuple.rows[index(--k)] = tree.row[index(n)];
  }
  return tuple;
}

TEST(RefereeTuples, ASequenceThatIsAColumnCountsAsThatColumn) {
  const AssociationProblem problem = known_tracks();
  const HypothesisTree& tree = problem.views()->tree;
  const int first = tree.layer_begin[index(tree.scans())];
  for (int a = first; a < tree.nodes(); ++a) {
    for (int b = first; b < tree.nodes(); ++b) {
      std::vector<double> x(index(problem.columns()), 0.0);
      x[index(tree.column[index(a)])] = 1.0;
      std::vector<double> both = x;
      both[index(tree.column[index(b)])] += 1.0;
      if (a == b) continue;
      const Tuple tuple = sequence(problem, b);
      const Examination mixed = examine(problem, x, std::vector{tuple});
      const Examination plain = examine(problem, both);
      EXPECT_TRUE(mixed.well_formed);
      EXPECT_NEAR(mixed.cost, plain.cost, 1e-9);
      EXPECT_EQ(mixed.row_violation, plain.row_violation);
      EXPECT_EQ(mixed.is_choice(), plain.is_choice());
    }
  }
}

TEST(RefereeTuples, WhatIsNoSequenceIsMalformed) {
  const AssociationProblem problem = known_tracks();
  const std::vector<double> nothing(index(problem.columns()), 0.0);
  const auto well_formed = [&](const Tuple& tuple) {
    return examine(problem, nothing, std::vector{tuple}).well_formed;
  };
  const int plot_of_scan_1 = 2;
  const int plot_of_scan_2 = 4;
  EXPECT_TRUE(well_formed({0, {plot_of_scan_1, plot_of_scan_2}}));
  EXPECT_TRUE(well_formed({0, {kNoRow, kNoRow}}));
  EXPECT_FALSE(well_formed({0, {plot_of_scan_2, kNoRow}})) << "a plot of another scan";
  EXPECT_FALSE(well_formed({0, {plot_of_scan_1}})) << "too short";
  EXPECT_FALSE(well_formed({0, {kNoRow, kNoRow, kNoRow}})) << "too long";
  EXPECT_FALSE(well_formed({plot_of_scan_1, {kNoRow, kNoRow}})) << "no track";
  EXPECT_FALSE(well_formed({-1, {kNoRow, kNoRow}}));
  EXPECT_FALSE(well_formed({0, {problem.rows(), kNoRow}}));
}

TEST(RefereeTuples, NobodyButTheViewsKnowsTheirCost) {
  AssociationProblem problem = known_tracks();
  const std::vector<double> nothing(index(problem.columns()), 0.0);
  const std::vector<Tuple> tuples = {{0, {kNoRow, kNoRow}}};
  auto views = std::make_shared<Views>(*problem.views());
  views->tuple_cost = [](const Tuple&) { return std::numeric_limits<double>::infinity(); };
  problem.attach(views);
  EXPECT_FALSE(examine(problem, nothing, tuples).well_formed) << "an infinite cost";
  problem.attach(nullptr);
  EXPECT_FALSE(examine(problem, nothing, tuples).well_formed) << "no views";
}

/// Columns of cost -3, -2 and -1 on one row each.
AssociationProblem three_alone() {
  ProblemBuilder builder;
  for (int r = 0; r < 3; ++r) {
    builder.add_row(1, RowUse::kAtMostOnce);
    builder.add_column(-3.0 + r, std::vector{r});
  }
  return builder.build();
}

std::string fault(const std::vector<Choice>& ranked) {
  Solution solution;
  solution.x = {1.0, 1.0, 1.0};
  solution.ranked = ranked;
  return ranking_fault(three_alone(), solution);
}

TEST(RefereeRanking, ARankingIsCheckedChoiceByChoice) {
  EXPECT_EQ(fault({}), "");
  EXPECT_EQ(fault({{0, 1, 2}, {0, 1}, {0, 2}, {0}}), "");
  EXPECT_NE(fault({{0, 1}, {0, 1, 2}}), "") << "the first is not x";
  EXPECT_NE(fault({{0, 1, 2}, {0, 2}, {0, 1}}), "") << "out of order";
  EXPECT_NE(fault({{0, 1, 2}, {0, 1}, {0, 1}}), "") << "twice";
  EXPECT_NE(fault({{0, 1, 2}, {0, 3}}), "") << "no such column";
  EXPECT_NE(fault({{0, 1, 2}, {0, 0}}), "") << "one column twice";
}

}  // namespace
}  // namespace mda::testing
