// Large flow graphs as tracking makes them, layer by layer, the same ones on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/api/flow.h"

namespace mda::testing {

/// Points of one scan are linked to points of the next `reach` scans.
struct TrackingShape {
  int scans = 20;
  /// Targets move in a square of side `side`, with steps of some `speed` and a constant velocity;
  /// 0: no geometry, `clutter` points per scan with links of random cost.
  int targets = 0;
  double mean_life = 1000.0;  ///< scans until a target ends and another one starts
  double detection = 0.9;
  int clutter = 0;  ///< false points per scan
  double side = 1000.0;
  double speed = 5.0;
  double gate = 15.0;        ///< longest link per scan; 0: every point is linked to every other one
  int reach = 2;             ///< 1 or more
  double links = 8.0;        ///< without geometry: mean number per point and layer; 0: all
  double worst_link = 8.0;   ///< without geometry: costs are drawn from [0, worst_link)
  double end_cost = 5.0;     ///< of a path's start, and of its end
  double terminals = 1.0;    ///< share of the points that may start a path, and that may end one
  double point_cost = -4.0;  ///< mean; drawn from a range of 2 around it
  bool whole_numbers = false;  ///< costs in whole units: many ties
};

/// Source, sink and a detection arc per point; any number of paths. Nodes are numbered in the order
/// of time. Costs are in units of 2^-20, or whole.
[[nodiscard]] FlowGraph tracking_graph(const TrackingShape& shape, std::uint64_t seed);

/// A window of `scans` scans with `tracks` known tracks, each a supply of 1; each scan has `tracks`
/// points, split in two nodes, and as many places to be missed in; all paths end in one node of
/// demand behind the last scan. Gated: links between neighbours only, else all of them.
[[nodiscard]] FlowGraph window_graph(int scans, int tracks, bool is_gated, std::uint64_t seed);

/// Links of a detection that joins a growing graph.
struct GrowingLink {
  int from;
  std::int64_t cost;
};
struct GrowingDetection {
  std::int64_t cost;
  std::optional<std::int64_t> entry;
  std::optional<std::int64_t> exit;
  std::vector<GrowingLink> links;
};

/// The points of tracking_graph(), scan by scan, numbered throughout.
[[nodiscard]] std::vector<std::vector<GrowingDetection>> tracking_scans(const TrackingShape& shape,
                                                                        std::uint64_t seed);

/// The graph of the first `scans` scans; its node 0 is the source and 1 the sink, detection d is
/// the arc from node 2 + 2 d to the next node.
[[nodiscard]] FlowGraph graph_of_scans(const std::vector<std::vector<GrowingDetection>>& all,
                                       std::size_t scans);

}  // namespace mda::testing
