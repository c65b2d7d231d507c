#include "algorithms/flow/scf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "algorithms/flow/flow_codes.h"
#include "algorithms/flow/viterbi_sequential.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_trees.h"

namespace mda {
namespace {

using testing::cost_of;
using testing::optimum;
using testing::random_tree_problem;
using testing::random_tree_shape;
using testing::row_violation;
using testing::tolerance;
using testing::TreeShape;

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

TreeShape shape_of(std::uint64_t seed) {
  TreeShape shape = random_tree_shape(seed, false);
  shape.must_go_on = seed % 2 == 0;
  return shape;
}

/// Sends a unit from `start` to the last node along the cheapest way that the flow so far leaves.
bool augment(const FlowGraph& graph, int start, std::vector<std::int64_t>& flow) {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max() / 2;
  std::vector<std::int64_t> distance(index(graph.nodes), kFar);
  std::vector<int> by(index(graph.nodes), -1);
  distance[index(start)] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
      const FlowArc& arc = graph.arcs[index(a)];
      const bool back = flow[index(a)] > 0;
      const int from = back ? arc.head : arc.tail;
      const int to = back ? arc.tail : arc.head;
      const std::int64_t length = distance[index(from)] + (back ? -arc.cost : arc.cost);
      if (distance[index(from)] == kFar || length >= distance[index(to)]) continue;
      distance[index(to)] = length;
      by[index(to)] = a;
      changed = true;
    }
  }
  for (int v = graph.nodes - 1; v != start;) {
    if (by[index(v)] < 0) return false;
    const FlowArc& arc = graph.arcs[index(by[index(v)])];
    flow[index(by[index(v)])] ^= 1;
    v = arc.head == v ? arc.tail : arc.head;
  }
  return true;
}

/// The method of successive shortest paths for unit capacities, unit supplies and one demand.
FlowResult plain_flow_code(const FlowGraph& graph) {
  FlowResult result;
  result.flow.assign(graph.arcs.size(), 0);
  for (int v = 0; v + 1 < graph.nodes; ++v) {
    if (graph.supply[index(v)] > 0 && !augment(graph, v, result.flow)) return {};
  }
  result.outcome = FlowOutcome::kOptimal;
  return result;
}

Solution scf(const AssociationProblem& problem, TieRule rule) {
  return make_scf({.tie_rule = rule}, plain_flow_code)->solve(problem, Budget{});
}

TEST(Scf, IsExactForOneScan) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = shape_of(seed);
    shape.scans = 1;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    for (const TieRule rule : {TieRule::kLiteral, TieRule::kCumulative}) {
      const Solution solution = scf(problem, rule);
      EXPECT_EQ(solution.stats.off_column_paths, 0);
      EXPECT_NEAR(cost_of(problem, solution), *optimum(problem), tolerance(problem));
    }
  }
}

TEST(Scf, IsExactForALoneTrackInTwoScans) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = shape_of(seed);
    shape.tracks = 1;
    shape.scans = 2;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    for (const TieRule rule : {TieRule::kLiteral, TieRule::kCumulative}) {
      EXPECT_NEAR(cost_of(problem, scf(problem, rule)), *optimum(problem), tolerance(problem));
    }
  }
}

/// The sequence is seen up to some scan and missed from then on.
bool has_no_gap(const AssociationProblem& problem, int column) {
  const auto rows = problem.rows_of(column);
  return std::all_of(rows.begin(), rows.end(),
                     [&](int r) { return problem.dimension(r) < static_cast<int>(rows.size()); });
}

/// Where costs depend on the last plot alone, and that is in the scan before, arcs cost what their
/// sequences do. A missed node forgets the plot, so sequences with gaps are judged by another's.
TEST(Scf, IsExactAmongSequencesWithoutGapsWhenCostsAreMarkovian) {
  int without_gap = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = shape_of(seed);
    shape.tracks = 1;
    shape.history = 0.0;
    shape.must_go_on = true;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    double best = std::numeric_limits<double>::infinity();
    for (int j = 0; j < problem.columns(); ++j) {
      if (has_no_gap(problem, j)) best = std::min(best, problem.cost(j));
    }
    const Solution solution = scf(problem, TieRule::kCumulative);
    const auto chosen = std::find(solution.x.begin(), solution.x.end(), 1.0);
    if (chosen == solution.x.end()) continue;
    const int column = static_cast<int>(chosen - solution.x.begin());
    if (!has_no_gap(problem, column)) continue;
    ++without_gap;
    EXPECT_NEAR(problem.cost(column), best, tolerance(problem));
  }
  EXPECT_GE(without_gap, 100);
}

TEST(Scf, AllFlowCodesAgree) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = shape_of(seed);
    shape.history = 2.0;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    const FlowGraph graph = flow_graph(layered_graph(problem, TieRule::kCumulative));
    const std::int64_t flow = flow_cost(graph, plain_flow_code(graph).flow);
    const double cost = cost_of(problem, scf(problem, TieRule::kCumulative));
    for (const FlowCode& code : flow_codes()) {
      SCOPED_TRACE(code.name);
      const FlowResult result = code.solve(graph);
      EXPECT_EQ(flow_fault(graph, result.flow), "");
      EXPECT_EQ(flow_cost(graph, result.flow), flow);
      if (!result.potential.empty() || code.name != "scf-lp") {  // only the LP may fail to prove
        EXPECT_EQ(certified_flow_bound(graph, result.potential), flow);
      }
      EXPECT_NEAR(cost_of(problem, make_scf({}, code.solve)->solve(problem, Budget{})), cost,
                  tolerance(problem));
    }
  }
}

TEST(Scf, SequencesOutsideTheColumnsAreCounted) {
  int off = 0;
  int foreign = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape;
    shape.tracks = 4;
    shape.plots = 4;
    shape.gate_nats = 0.0;
    shape.history = 8.0;
    shape.must_go_on = seed % 2 == 0;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    const Solution solution = scf(problem, TieRule::kCumulative);
    EXPECT_EQ(row_violation(problem, solution), 0.0);
    off += *solution.stats.off_column_paths;
    foreign += static_cast<int>(solution.tuples.size());
  }
  EXPECT_GE(off, 30);
  EXPECT_GE(foreign, 10);
}

TEST(Scf, SaysWhyItDeclines) {
  const auto algorithm = make_scf({}, plain_flow_code);
  Shape shape;
  EXPECT_EQ(algorithm->can_solve(shape).reason, "it needs the hypothesis tree of the window");
  shape.has_tree = true;
  EXPECT_TRUE(algorithm->can_solve(shape).ok);
  shape.known_tracks = false;
  EXPECT_EQ(algorithm->can_solve(shape).reason, "tracks are born in this window");
}

TEST(Scf, HandsOnWhyTheFlowCodeDeclines) {
  const auto decline = [](const FlowGraph& /*graph*/) {
    FlowResult result;
    result.outcome = FlowOutcome::kDeclined;
    result.reason = "not today";
    return result;
  };
  const Solution solution =
      make_scf({}, decline)->solve(random_tree_problem(shape_of(2), 2), Budget{});
  EXPECT_EQ(solution.status, Status::kNoAnswer);
  EXPECT_EQ(solution.note, "not today");
}

/// Of one track, the cheapest path is the cheapest flow.
TEST(ViterbiSequential, IsTheFlowForALoneTrack) {
  const auto viterbi = make_viterbi_sequential();
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = shape_of(seed);
    shape.tracks = 1;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    EXPECT_NEAR(cost_of(problem, viterbi->solve(problem, Budget{})),
                cost_of(problem, scf(problem, TieRule::kCumulative)), tolerance(problem));
  }
}

TEST(ViterbiSequential, IsNotBetterThanTheFlowForOneScan) {
  const auto viterbi = make_viterbi_sequential();
  int worse = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    TreeShape shape = shape_of(seed);
    shape.scans = 1;
    const AssociationProblem problem = random_tree_problem(shape, seed);
    const double in_sequence = cost_of(problem, viterbi->solve(problem, Budget{}));
    const double together = cost_of(problem, scf(problem, TieRule::kCumulative));
    EXPECT_GE(in_sequence, together - tolerance(problem));
    worse += in_sequence > together + tolerance(problem) ? 1 : 0;
  }
  EXPECT_GE(worse, 5);
}

}  // namespace
}  // namespace mda
