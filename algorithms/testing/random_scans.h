// Random single scans, in which tracks want the plots in their gates; the same on every machine.
#pragma once

#include <cstdint>
#include <limits>

#include "algorithms/api/problem.h"

namespace mda::testing {

/// Tracks and plots lie anywhere in a rectangle; a gate is a square around a track.
struct ScanShape {
  int tracks = 10;
  int plots = 12;
  double length = 10.0;
  double height = 0.0;
  double gate = std::numeric_limits<double>::infinity();  ///< half a side: every plot with no limit
  double spread_nats = 8.0;                               ///< pairs cost from -spread to spread
};

/// Pairs in a gate, of random cost; every row at most once.
[[nodiscard]] AssociationProblem random_scan(const ScanShape& shape, std::uint64_t seed);

}  // namespace mda::testing
