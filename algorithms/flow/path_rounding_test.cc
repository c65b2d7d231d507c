#include "algorithms/flow/path_rounding.h"

#include <gtest/gtest.h>

#include <set>

#include "algorithms/testing/draw.h"
#include "algorithms/testing/random_trees.h"

namespace mda {
namespace {

using testing::Draw;
using testing::random_tree_problem;
using testing::TreeShape;

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

LayeredGraph graph_of(std::uint64_t seed) {
  TreeShape shape;
  shape.tracks = 1;
  shape.scans = 4;
  shape.plots = 3;
  shape.gate_nats = 4.0;
  shape.must_go_on = seed % 2 == 0;
  const AssociationProblem problem = random_tree_problem(shape, seed);
  return layered_graphs_by_track(problem, TieRule::kCumulative).front();
}

/// Adds a random walk of this weight.
void add_walk(const LayeredGraph& graph, double weight, Draw& draw, std::vector<double>& flow) {
  for (int v = 0; v != graph.destination();) {
    std::vector<std::size_t> out;
    for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
      if (graph.arcs[a].tail == v) out.push_back(a);
    }
    const std::size_t a = out[index(draw.below(static_cast<int>(out.size())))];
    flow[a] += weight;
    v = graph.arcs[a].head;
  }
}

TEST(PathsOfFlow, AddUpToTheFlow) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const LayeredGraph graph = graph_of(seed);
    Draw draw(seed);
    std::vector<double> flow(graph.arcs.size(), 0.0);
    for (const double weight : {0.5, 0.25, 0.125, 0.125}) add_walk(graph, weight, draw, flow);
    double cost = 0.0;
    double gone = 0.0;
    for (std::size_t a = 0; a < flow.size(); ++a) cost += flow[a] * graph.arcs[a].cost;
    double weight_of_paths = 0.0;
    for (const WeightedPath& path : paths_of_flow(graph, flow)) {
      EXPECT_GT(path.weight, 0.0);
      EXPECT_EQ(path.tuple.track, graph.nodes.front().row);
      EXPECT_TRUE(path.tuple.rows.empty() || path.tuple.rows.size() == index(graph.scans()));
      weight_of_paths += path.weight;
      gone += path.weight * path.cost;
    }
    EXPECT_NEAR(weight_of_paths, 1.0, 1e-9);
    EXPECT_NEAR(gone, cost, 1e-9);
  }
}

TEST(DisjointPaths, AreDisjointAndLeaveNoPathThatWouldFit) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Draw draw(seed);
    constexpr int kTracks = 4;
    constexpr int kPlots = 6;
    std::vector<WeightedPath> paths;
    for (int i = 0; i < 12; ++i) {
      const int plot = kTracks + draw.below(kPlots);
      paths.push_back({0.25 * (1 + draw.below(3)),
                       draw.unit(),
                       {draw.below(kTracks), {draw.chance(0.3) ? kNoRow : plot}}});
    }
    std::set<int> used;
    for (const Tuple& tuple : disjoint_paths(paths, kTracks + kPlots)) {
      EXPECT_TRUE(used.insert(tuple.track).second);
      for (const int row : tuple.rows) EXPECT_TRUE(row == kNoRow || used.insert(row).second);
    }
    for (const WeightedPath& path : paths) {
      const int plot = path.tuple.rows.front();
      EXPECT_TRUE(used.contains(path.tuple.track) || used.contains(plot));
    }
  }
}

TEST(DisjointPaths, TakeTheHeavierAndThenTheCheaper) {
  const std::vector<WeightedPath> paths = {
      {0.5, -1.0, {0, {3}}}, {0.5, -2.0, {1, {3}}}, {0.75, 5.0, {2, {4}}}, {0.25, -9.0, {0, {4}}}};
  const std::vector<Tuple> taken = disjoint_paths(paths, 5);
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_EQ(taken[0].track, 2);
  EXPECT_EQ(taken[1].track, 1);
}

}  // namespace
}  // namespace mda
