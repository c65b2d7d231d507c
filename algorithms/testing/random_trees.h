// Random windows that come with their hypothesis tree, the same ones on every machine.
#pragma once

#include <cstdint>

#include "algorithms/api/problem.h"

namespace mda::testing {

struct TreeShape {
  int tracks = 3;
  int scans = 3;
  int plots = 3;           ///< per scan
  double gate_nats = 2.0;  ///< a plot that costs a hypothesis more than this is not in its gate
  double history = 1.0;    ///< how much of a step's cost depends on more than the last plot, nats
  bool births = false;     ///< tracks may begin in the window; needs at-most-once tracks
  bool must_go_on = true;  ///< every track exactly once, any sequence a column, tuple_cost known;
                           ///< otherwise at most once, columns of negative cost, no tuple_cost
};

/// Some shape whose problems have at most 14 rows. `births`: of all shapes; otherwise known tracks.
[[nodiscard]] TreeShape random_tree_shape(std::uint64_t seed, bool births);

/// A step costs what a random function of the track's history and the plot says: a miss always the
/// same, a plot more or less than that. `order` numbers the same problem's rows, columns and nodes
/// in another way (0: in the plain one).
[[nodiscard]] AssociationProblem random_tree_problem(const TreeShape& shape, std::uint64_t seed,
                                                     std::uint64_t order = 0);

}  // namespace mda::testing
