// Global nearest neighbour: the best assignment of plots to tracks in one scan.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// The optimum of problems with at most two dimensions (one scan with fixed tracks, or two scans or
/// sensors without), as a rectangular assignment problem: rows of the lower dimension are assigned
/// to rows of the higher one. Takes exactly-once rows of any kind and proves that there is no
/// choice where there is none; its prices certify the bound. Polynomial: see AssignmentSolver.
/// Source: Bar-Shalom and Li, "Multitarget-Multisensor Tracking: Principles and Techniques" (1995).
[[nodiscard]] std::unique_ptr<Associator> make_gnn();

}  // namespace mda
