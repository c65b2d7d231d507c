// Multi-scan association as the flow of a single commodity.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"
#include "algorithms/api/flow.h"
#include "algorithms/flow/layered_graph.h"

namespace mda {

struct ScfOptions {
  TieRule tie_rule = TieRule::kCumulative;
};

/// Finds the cheapest set of node-disjoint paths, one per track, through the layered graph of the
/// window, by the given code; polynomial if the code is. Each track takes the sequence of the path
/// that starts from it. The costs on the arcs are those of the tracks' best partial paths, not of
/// their own, hence neither a bound nor an optimum; exact for K = 1. Needs the hypothesis tree and
/// known tracks. Source: Battistelli et al. 2008, section III.
[[nodiscard]] std::unique_ptr<Associator> make_scf(const ScfOptions& options, SolveFlow code);

}  // namespace mda
