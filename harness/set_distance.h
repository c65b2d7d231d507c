// Distances between a set of true positions and a set of estimates: GOSPA (Rahmathullah,
// Garcia-Fernandez, Svensson 2017, alpha = 2) and OSPA (Schuhmacher, Vo, Vo 2008), both of order
// p = 2.
#pragma once

#include <span>

#include "algorithms/api/associator.h"

namespace mda {

struct Position {
  double x = 0.0;
  double y = 0.0;
};

/// In the unit of the positions; the three parts are squared and add up to gospa^2.
struct SetDistance {
  double gospa = 0.0;
  double localisation_squared = 0.0;  ///< of the assigned pairs
  double missed_squared = 0.0;        ///< c^2 / 2 for each true position without an estimate
  double false_squared = 0.0;         ///< c^2 / 2 for each estimate without a true position
  double ospa = 0.0;                  ///< 0 if both sets are empty
};

/// Both distances come from one optimal assignment of pairs nearer than the cut-off c > 0, each
/// worth d^2 - c^2: an association problem of two dimensions, which `assignment` solves (an exact
/// entry of the catalogue). Throws std::runtime_error if it does not.
[[nodiscard]] SetDistance set_distance(std::span<const Position> truth,
                                       std::span<const Position> estimates, double cut_off,
                                       Associator& assignment);

}  // namespace mda
