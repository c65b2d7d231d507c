#include "algorithms/flow/layered_graph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "algorithms/testing/random_trees.h"

namespace mda {
namespace {

using testing::random_tree_problem;
using testing::random_tree_shape;
using testing::TreeShape;

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kWindows = 300;

TreeShape shape_of(std::uint64_t seed) {
  TreeShape shape = random_tree_shape(seed, false);
  shape.must_go_on = seed % 2 == 0;
  return shape;
}

int layer_of(const LayeredGraph& graph, int node) {
  int layer = 0;
  while (node >= graph.layer_begin[index(layer) + 1]) ++layer;
  return layer;
}

/// The child by which the arc leaves its tail's representative, kNoNode if there is none.
int child_of(const HypothesisTree& tree, const LayeredGraph& graph, const LayeredArc& arc) {
  const LayeredNode& head = graph.nodes[index(arc.head)];
  const int row = head.plot ? head.row : kNoRow;
  const int from = graph.nodes[index(arc.tail)].tree_node;
  for (int c = tree.child_begin[index(from)]; c < tree.child_end[index(from)]; ++c) {
    if (tree.row[index(c)] == row) return c;
  }
  return kNoNode;
}

/// Arcs into node v, with the child each follows.
struct In {
  int tail;
  int child;
  double step;
};
std::vector<In> arcs_into(const HypothesisTree& tree, const LayeredGraph& graph, int v) {
  std::vector<In> in;
  for (const LayeredArc& arc : graph.arcs) {
    if (arc.head != v) continue;
    const int child = child_of(tree, graph, arc);
    in.push_back({arc.tail, child, tree.step[index(child)]});
  }
  return in;
}

TEST(LayeredGraph, HasTheSizeOfThePapersFigure2) {
  TreeShape shape;
  shape.tracks = 2;
  shape.scans = 3;
  shape.plots = 2;
  shape.gate_nats = 1000.0;
  const LayeredGraph graph = layered_graph(random_tree_problem(shape, 1), TieRule::kLiteral);
  EXPECT_EQ(graph.destination() + 1, 15);
  std::vector<int> arcs_out(4, 0);
  for (const LayeredArc& arc : graph.arcs) ++arcs_out[index(layer_of(graph, arc.tail))];
  EXPECT_EQ(arcs_out, (std::vector{6, 12, 12, 4}));
}

TEST(LayeredGraph, EveryArcIsAChildOfItsTailsRepresentative) {
  for (std::uint64_t seed = 1; seed <= kWindows; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_tree_problem(shape_of(seed), seed);
    const HypothesisTree& tree = problem.views()->tree;
    const LayeredGraph graph = layered_graph(problem, TieRule::kCumulative);
    for (const LayeredArc& arc : graph.arcs) {
      EXPECT_LT(arc.tail, arc.head);
      const bool from_track = arc.tail < graph.tracks();
      if (arc.head == graph.destination()) {
        EXPECT_EQ(arc.cost, 0.0);
        const bool droppable =
            from_track && problem.use(graph.nodes[index(arc.tail)].row) == RowUse::kAtMostOnce;
        EXPECT_TRUE(droppable || layer_of(graph, arc.tail) == graph.scans());
        continue;
      }
      EXPECT_EQ(layer_of(graph, arc.head), layer_of(graph, arc.tail) + 1);
      const int child = child_of(tree, graph, arc);
      ASSERT_NE(child, kNoNode);
      const double cost = from_track ? tree.cost[index(child)] : tree.step[index(child)];
      EXPECT_NEAR(arc.cost, cost, 1e-12);
    }
  }
}

TEST(LayeredGraph, RepresentativesFollowTheCheapestArc) {
  for (std::uint64_t seed = 1; seed <= kWindows; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_tree_problem(shape_of(seed), seed);
    const HypothesisTree& tree = problem.views()->tree;
    const LayeredGraph graph = layered_graph(problem, TieRule::kCumulative);
    for (int v = graph.tracks(); v < graph.destination(); ++v) {
      double least = std::numeric_limits<double>::infinity();
      for (const In& in : arcs_into(tree, graph, v)) least = std::min(least, in.step);
      double least_cumulative = std::numeric_limits<double>::infinity();
      for (const In& in : arcs_into(tree, graph, v)) {
        if (in.step != least) continue;
        least_cumulative = std::min(least_cumulative, graph.nodes[index(in.tail)].cumulative);
      }
      const LayeredNode& node = graph.nodes[index(v)];
      EXPECT_EQ(tree.step[index(node.tree_node)], least);
      EXPECT_NEAR(node.cumulative, least + least_cumulative, 1e-12);
    }
  }
}

TEST(LayeredGraph, APlotLeadsToTheMissedNodeThatFitsItBest) {
  int led_by_a_missed_node = 0;
  for (std::uint64_t seed = 1; seed <= kWindows; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_tree_problem(shape_of(seed), seed);
    const HypothesisTree& tree = problem.views()->tree;
    const LayeredGraph graph = layered_graph(problem, TieRule::kLiteral);
    for (const LayeredArc& arc : graph.arcs) {
      if (arc.head == graph.destination() || graph.nodes[index(arc.head)].plot) continue;
      const LayeredNode& tail = graph.nodes[index(arc.tail)];
      EXPECT_EQ(graph.nodes[index(arc.head)].row, tail.miss_row);
      if (!tail.plot) {
        EXPECT_EQ(tail.miss_row, tail.row) << "missed nodes keep their index";
        continue;
      }
      double least = std::numeric_limits<double>::infinity();
      int best = tree.track[index(tail.tree_node)];
      for (const In& in : arcs_into(tree, graph, arc.tail)) {
        if (graph.nodes[index(in.tail)].plot || in.step >= least) continue;
        least = in.step;
        best = graph.nodes[index(in.tail)].row;
      }
      EXPECT_EQ(tail.miss_row, best);
      led_by_a_missed_node += std::isfinite(least) ? 1 : 0;
    }
  }
  EXPECT_GE(led_by_a_missed_node, 100);
}

/// All missed detections of these windows cost the same.
TEST(LayeredGraph, TheLiteralTieLeavesMissedNodesWithoutTheirPlots) {
  int repaired_by_the_other_rule = 0;
  for (std::uint64_t seed = 2; seed <= kWindows; seed += 2) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_tree_problem(shape_of(seed), seed);
    const HypothesisTree& tree = problem.views()->tree;
    for (const LayeredNode& node : layered_graph(problem, TieRule::kLiteral).nodes) {
      if (node.plot) continue;
      EXPECT_EQ(tree.track[index(node.tree_node)], node.row);
      for (int n = node.tree_node; tree.parent[index(n)] != kNoNode; n = tree.parent[index(n)]) {
        EXPECT_EQ(tree.row[index(n)], kNoRow);
      }
    }
    for (const LayeredNode& node : layered_graph(problem, TieRule::kCumulative).nodes) {
      if (node.plot || tree.parent[index(node.tree_node)] == kNoNode) continue;
      const int before = tree.parent[index(node.tree_node)];
      repaired_by_the_other_rule +=
          tree.parent[index(before)] != kNoNode && tree.row[index(before)] != kNoRow ? 1 : 0;
    }
  }
  EXPECT_GE(repaired_by_the_other_rule, 50);
}

TEST(LayeredGraph, ByTrackThereIsOneMissedNodePerScan) {
  for (std::uint64_t seed = 1; seed <= kWindows; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_tree_problem(shape_of(seed), seed);
    const HypothesisTree& tree = problem.views()->tree;
    for (const LayeredGraph& graph : layered_graphs_by_track(problem, TieRule::kCumulative)) {
      ASSERT_EQ(graph.tracks(), 1);
      const int track = graph.nodes.front().row;
      std::vector<int> missed(index(graph.scans()) + 1, 0);
      for (int v = 0; v < graph.destination(); ++v) {
        EXPECT_EQ(tree.track[index(graph.nodes[index(v)].tree_node)], track);
        if (!graph.nodes[index(v)].plot) ++missed[index(layer_of(graph, v))];
      }
      for (const int count : missed) EXPECT_LE(count, 1);
    }
  }
}

TEST(FlowGraph, SplitsEveryNodeAboveTheTracks) {
  for (std::uint64_t seed = 1; seed <= kWindows; ++seed) {
    SCOPED_TRACE(seed);
    const LayeredGraph graph =
        layered_graph(random_tree_problem(shape_of(seed), seed), TieRule::kCumulative);
    const FlowGraph flow = flow_graph(graph);
    EXPECT_TRUE(fits_flow_codes(flow));
    EXPECT_EQ(flow.nodes, 2 * graph.destination() - graph.tracks() + 1);
    ASSERT_EQ(flow.arcs.size(), graph.arcs.size() + graph.nodes.size() - index(graph.tracks()));
    for (const FlowArc& arc : flow.arcs) {
      EXPECT_LT(arc.tail, arc.head);
      EXPECT_EQ(arc.capacity, 1);
    }
    double unit = 0x1.0p-20;
    for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
      if (flow.arcs[a].cost == 0) continue;
      const double nats_per_unit = graph.arcs[a].cost / static_cast<double>(flow.arcs[a].cost);
      unit = std::exp2(std::round(std::log2(nats_per_unit)));
      break;
    }
    EXPECT_LE(unit, 0x1.0p-20);
    for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
      EXPECT_NEAR(static_cast<double>(flow.arcs[a].cost) * unit, graph.arcs[a].cost, 0.5 * unit);
    }
  }
}

}  // namespace
}  // namespace mda
