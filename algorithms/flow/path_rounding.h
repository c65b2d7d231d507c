// From a fractional flow of one unit per track to one path for every track.
#pragma once

#include <vector>

#include "algorithms/flow/layered_graph.h"

namespace mda {

/// A path from a graph's only track to its destination.
struct WeightedPath {
  double weight = 0.0;  ///< its share of the track's unit, in (0, 1]
  double cost = 0.0;    ///< of its arcs, nats
  Tuple tuple;          ///< without rows: the track is dropped
};

/// Splits a flow of one unit through the graph of one track: of the arcs out of a node the one with
/// the most flow left (ties: the cheapest) leads on. flow[a] in [0, 1] on all arcs but those to the
/// destination from the last layer. O(arcs x K).
[[nodiscard]] std::vector<WeightedPath> paths_of_flow(const LayeredGraph& graph,
                                                      const std::vector<double>& flow);

/// The heaviest path first (weights within 1e-6 count as equal, then the cheapest), each track and
/// each plot at most once. `rows`: of the problem. O(paths x (log paths + K)).
[[nodiscard]] std::vector<Tuple> disjoint_paths(std::vector<WeightedPath> paths, int rows);

}  // namespace mda
