#include "harness/flow_referee.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "algorithms/catalog.h"
#include "harness/testing/flow_files.h"

namespace mda::testing {
namespace {

/// Two ways for one target, one of them cheaper.
const std::string kOneTarget = "p min 4 4\nn 1 0\nn 4 0\na 1 2 5\na 2 3 -9.5\na 3 4 1\na 2 4 -6\n";

FlowFile parsed(const std::string& text) { return parse_flow_file(text, "g.min"); }

/// Of the first code.
FlowResult solved(const FlowFile& file) { return flow_codes().front().solve(file.graph); }

TEST(FlowRefereeTest, TinyGraphsByHand) {
  struct Case {
    std::string text;
    double cost;
    std::int64_t paths;
  };
  const std::vector<Case> cases = {
      {kOneTarget, -3.5, 1},
      {"p min 2 1\nn 2 9\nn 1 9\na 2 1 0.25\n", 0.0, 0},  // no track is cheaper than one
      {"p min 3 4\nn 1 0\nn 3 0\na 1 2 -1\na 1 2 -2\na 2 3 0.5\na 2 3 3\n", -1.5, 1},
      {"p min 2 2\nn 1 0\nn 2 0\na 1 2 -1\na 1 2 -0.125\n", -1.125, 2},
      {"p min 2 0\n", 0.0, 0},
      {"p min 3 3\nn 1 4\nn 3 -4\na 1 3 0 3 10\na 1 2 0 9 2\na 2 3 0 2 3\n", 30.0, 4},
      {"p min 3 3\nn 1 4\nn 3 -4\na 1 3 3 3 10\na 1 2 0 9 2\na 2 3 0 2 3\n", 35.0, 4},
      {"p min 2 2\na 1 2 0 5 -3\na 2 1 0 4 1\n", -8.0, 0},  // a cycle that pays
      {"p min 2 3\nn 1 1\nn 2 -1\na 1 2 1 1 7\na 2 1 0 1 1\na 1 2 0 9 1\n", 7.0, 1},
  };
  for (const Case& expected : cases) {
    const FlowFile file = parsed(expected.text);
    const FlowVerdict verdict = judge_flow(file, solved(file));
    EXPECT_EQ(verdict.refutation, "") << expected.text;
    ASSERT_TRUE(verdict.cost && verdict.paths && verdict.certified_bound) << expected.text;
    EXPECT_EQ(*verdict.cost, expected.cost) << expected.text;
    EXPECT_EQ(*verdict.paths, expected.paths) << expected.text;
    EXPECT_LE(*verdict.certified_bound, expected.cost) << expected.text;
    EXPECT_NEAR(*verdict.certified_bound, expected.cost, 1e-6) << expected.text;
  }
}

/// The cheapest choice of at most 20 arcs that keeps flow at every node but the first and the last.
double cheapest_choice(const FlowFile& file) {
  double best = std::numeric_limits<double>::infinity();
  const std::size_t arcs = file.cost.size();
  for (std::uint32_t choice = 0; choice < (1U << arcs); ++choice) {
    FlowResult result;
    for (std::size_t a = 0; a < arcs; ++a) result.flow.push_back((choice >> a) & 1U);
    if (!flow_fault(file.graph, result.flow).empty()) continue;
    double cost = 0.0;
    for (std::size_t a = 0; a < arcs; ++a) {
      cost += static_cast<double>(result.flow[a]) * file.cost[a];
    }
    best = std::min(best, cost);
  }
  return best;
}

TEST(FlowRefereeTest, TrackingCostsAreThoseOfEveryChoiceTried) {
  int tried = 0;
  for (std::uint64_t seed = 1; tried < 100; ++seed) {
    const FlowLines lines = random_tracking_lines(seed);
    if (lines.arcs.size() > 12) continue;
    ++tried;
    const FlowFile file = parsed(text_of(lines));
    const double best = cheapest_choice(file);
    for (const FlowCode& code : flow_codes()) {
      const FlowResult result = code.solve(file.graph);
      if (result.outcome == FlowOutcome::kDeclined) continue;
      const FlowVerdict verdict = judge_flow(file, result);
      EXPECT_EQ(verdict.refutation, "") << code.name << "\n" << text_of(lines);
      EXPECT_EQ(verdict.cost, best) << code.name << "\n" << text_of(lines);
    }
  }
}

/// The answers of all codes that take the graph: no cost where it is infeasible.
std::optional<double> agreed_cost(const FlowLines& lines) {
  const FlowFile file = parsed(text_of(lines));
  const FlowVerdict first = judge_flow(file, solved(file));
  for (const FlowCode& code : flow_codes()) {
    const FlowResult result = code.solve(file.graph);
    if (result.outcome == FlowOutcome::kDeclined) continue;
    const FlowVerdict verdict = judge_flow(file, result);
    EXPECT_EQ(verdict.refutation, "") << code.name << "\n" << text_of(lines);
    EXPECT_EQ(verdict.cost, first.cost) << code.name << "\n" << text_of(lines);
    EXPECT_EQ(verdict.paths.has_value(), verdict.cost.has_value());
    if (verdict.cost && verdict.certified_bound) {
      EXPECT_LE(*verdict.certified_bound, *verdict.cost);
    }
  }
  return first.cost;
}

RC_GTEST_PROP(FlowRefereeTest, OrderAndNumbersDoNotMatterInTheTrackingDialect,
              (std::uint64_t seed)) {
  const FlowLines lines = random_tracking_lines(seed);
  RC_ASSERT(agreed_cost(reordered(lines, seed)) == agreed_cost(lines));
}

RC_GTEST_PROP(FlowRefereeTest, OrderAndNumbersDoNotMatterInDimacs, (std::uint64_t seed)) {
  const FlowLines lines = random_dimacs_lines(seed);
  RC_ASSERT(agreed_cost(reordered(lines, seed)) == agreed_cost(lines));
}

TEST(FlowRefereeTest, RandomDimacsGraphsAreOfBothKinds) {
  int feasible = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    feasible += agreed_cost(random_dimacs_lines(seed)) ? 1 : 0;
  }
  EXPECT_GT(feasible, 10);
  EXPECT_LT(feasible, 90);
}

TEST(FlowRefereeTest, BoundsHoldForTheFilesOwnCosts) {
  // No scale gives thirds; the bound must be one for the costs as they stand.
  const FlowFile file =
      parsed("p min 3 3\nn 1 0\nn 3 0\na 1 2 -0.33333333333\na 2 3 0.1\na 2 3 0.2\n");
  const FlowVerdict verdict = judge_flow(file, solved(file));
  ASSERT_TRUE(verdict.cost && verdict.certified_bound);
  EXPECT_DOUBLE_EQ(*verdict.cost, -0.33333333333 + 0.1);
  EXPECT_LE(*verdict.certified_bound, *verdict.cost);
  EXPECT_NEAR(*verdict.certified_bound, *verdict.cost, 1e-8);
}

TEST(FlowRefereeTest, WrongAnswersAreRefuted) {
  const FlowFile file = parsed(kOneTarget);
  const FlowResult right = solved(file);
  ASSERT_EQ(judge_flow(file, right).refutation, "");
  FlowResult lost = right;
  lost.flow[2] = 0;
  FlowResult double_flow = right;
  for (std::int64_t& flow : double_flow.flow) flow *= 2;
  FlowResult short_flow = right;
  short_flow.flow.pop_back();
  FlowResult none = right;
  std::fill(none.flow.begin(), none.flow.end(), 0);
  FlowResult dearer = right;
  dearer.flow = {1, 0, 0, 1};
  FlowResult weak = right;
  std::fill(weak.potential.begin(), weak.potential.end(), 0);
  FlowResult useless = right;
  useless.potential[0] = useless.potential[3] + 1;
  FlowResult infeasible;
  for (const FlowResult& wrong :
       {lost, double_flow, short_flow, none, dearer, weak, useless, infeasible}) {
    EXPECT_NE(judge_flow(file, wrong).refutation, "");
  }
  EXPECT_FALSE(judge_flow(file, lost).cost.has_value());
  EXPECT_EQ(judge_flow(file, dearer).cost, -1.0);
}

TEST(FlowRefereeTest, AnOptimumWithoutPotentialsIsTakenWithoutABound) {
  const FlowFile file = parsed(kOneTarget);
  FlowResult result = solved(file);
  result.potential.clear();
  const FlowVerdict verdict = judge_flow(file, result);
  EXPECT_EQ(verdict.refutation, "");
  EXPECT_EQ(verdict.cost, -3.5);
  EXPECT_FALSE(verdict.certified_bound.has_value());
}

}  // namespace
}  // namespace mda::testing
