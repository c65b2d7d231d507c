// Shortest paths through the layered graph, one track at a time.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Viterbi paths in sequence: of the remaining tracks, that one whose cheapest path through what is
/// left of the layered graph gains most against missing every scan (or being dropped) takes its
/// path, whose nodes then leave the graph; a track that has no path left misses every scan. The
/// graph is that of the single-commodity flow, ties by cumulative cost, so the difference between
/// the two is what optimising all tracks jointly is worth.
/// O(T x arcs). Needs the hypothesis tree and known tracks. Source: after Pulford 2006, as cited
/// by Battistelli et al. 2008, section III; the order of the tracks is ours.
[[nodiscard]] std::unique_ptr<Associator> make_viterbi_sequential();

}  // namespace mda
