#include "algorithms/backends/growing_assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "algorithms/backends/assignment_flow.h"
#include "algorithms/testing/tracking_graphs.h"

namespace mda {
namespace {

using Scans = std::vector<std::vector<testing::GrowingDetection>>;

void append(const std::vector<testing::GrowingDetection>& scan, GrowingAssignment& growing) {
  for (const testing::GrowingDetection& detection : scan) {
    growing.add_detection(detection.cost, *detection.entry, *detection.exit);
    for (const testing::GrowingLink& link : detection.links) growing.add_link(link.from, link.cost);
  }
  growing.update();
}

/// In the numbering of graph_of_scans().
std::vector<std::int64_t> potentials(const GrowingAssignment& growing, int nodes) {
  std::vector<std::int64_t> potential(2);
  for (int d = 0; 2 + 2 * d < nodes; ++d) {
    potential.push_back(growing.entry_potential(d));
    potential.push_back(growing.exit_potential(d));
  }
  return potential;
}

std::int64_t cheapest_link(const testing::GrowingDetection& to, int from) {
  std::int64_t cheapest = INT64_MAX;
  for (const testing::GrowingLink& link : to.links) {
    if (link.from == from) cheapest = std::min(cheapest, link.cost);
  }
  return cheapest;
}

/// Follows the paths; every detection at most once.
std::int64_t cost_of_paths(const GrowingAssignment& growing, const Scans& scans) {
  std::vector<testing::GrowingDetection> all;
  for (const auto& scan : scans) all.insert(all.end(), scan.begin(), scan.end());
  std::vector<bool> is_seen(all.size());
  std::int64_t cost = 0;
  for (const int start : growing.starts()) {
    cost += all[static_cast<std::size_t>(start)].entry.value();
    for (int here = start; here != GrowingAssignment::kNone;) {
      const auto d = static_cast<std::size_t>(here);
      EXPECT_TRUE(growing.is_used(here));
      EXPECT_FALSE(is_seen[d]);
      is_seen[d] = true;
      const int next = growing.next(here);
      cost += all[d].cost;
      cost += next == GrowingAssignment::kNone
                  ? all[d].exit.value()
                  : cheapest_link(all[static_cast<std::size_t>(next)], here);
      here = next;
    }
  }
  return cost;
}

std::vector<testing::TrackingShape> shapes() {
  return {
      {.scans = 15, .targets = 8, .mean_life = 6.0, .clutter = 3, .side = 40.0},
      {.scans = 15, .clutter = 8, .reach = 2, .links = 3.0, .whole_numbers = true},
      {.scans = 15, .clutter = 6, .reach = 1, .links = 0.0},
      {.scans = 15, .clutter = 8, .worst_link = 2.0, .end_cost = 20.0, .point_cost = -1.0},
      {.scans = 15, .clutter = 8, .worst_link = -3.0, .end_cost = -1.0, .point_cost = 2.0},
  };
}

TEST(GrowingAssignment, IsOptimalWithProofAfterEveryScan) {
  for (const testing::TrackingShape& shape : shapes()) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Scans scans = testing::tracking_scans(shape, seed);
      GrowingAssignment growing;
      for (std::size_t s = 0; s < scans.size(); ++s) {
        append(scans[s], growing);
        const FlowGraph graph = testing::graph_of_scans(scans, s + 1);
        const FlowResult batch = assignment_flow(graph);
        ASSERT_EQ(growing.cost(), flow_cost(graph, batch.flow)) << "seed " << seed << " scan " << s;
        ASSERT_EQ(certified_flow_bound(graph, potentials(growing, graph.nodes)), growing.cost());
        ASSERT_EQ(cost_of_paths(growing, scans), growing.cost());
      }
    }
  }
}

TEST(GrowingAssignment, RefusesWhatIsNotOlderOrTooLarge) {
  GrowingAssignment growing;
  EXPECT_THROW(growing.add_link(0, 1), std::invalid_argument);
  growing.add_detection(-1, 0, 0);
  EXPECT_THROW(growing.add_link(0, 1), std::invalid_argument);
  EXPECT_THROW(growing.add_link(-1, 1), std::invalid_argument);
  growing.add_detection(-1, 0, 0);
  EXPECT_THROW(growing.add_link(0, INT64_MIN), std::invalid_argument);
  EXPECT_THROW(growing.add_detection(0, INT64_MAX, 0), std::invalid_argument);
  growing.add_link(0, -5);
  growing.update();
  EXPECT_EQ(growing.cost(), -7);
  EXPECT_EQ(growing.next(0), 1);
}

}  // namespace
}  // namespace mda
