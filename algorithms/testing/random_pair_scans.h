// Random scans of fixed tracks that come with their pairs view, the same ones on every machine.
#pragma once

#include <cstdint>

#include "algorithms/api/problem.h"

namespace mda::testing {

struct PairScanShape {
  int tracks = 3;
  int plots = 4;
  double side_km = 1.5;  ///< of the square in which the tracks and the clutter are
  double gate = 9.21;    ///< chi-square; 0 and less: no pair has a column
  double detection_probability = 0.7;
  bool must_go_on = true;  ///< every track exactly once, otherwise at most once
};

/// Some shape with at most 5 tracks and 8 plots, none of either included.
[[nodiscard]] PairScanShape random_pair_scan_shape(std::uint64_t seed);

/// Tracks at random, with covariances of their own; two plots of three lie around some track. A
/// column costs what the track cost before, and minus the log likelihood ratio of the plot against
/// clutter, or of no detection. `order` numbers the same scan's tracks, plots, rows and columns in
/// another way (0: in the plain one).
[[nodiscard]] AssociationProblem random_pair_scan(const PairScanShape& shape, std::uint64_t seed,
                                                  std::uint64_t order = 0);

}  // namespace mda::testing
