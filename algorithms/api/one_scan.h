// What the methods for a single scan have in common, and whoever lifts them to windows.
#pragma once

#include <vector>

#include "algorithms/api/associator.h"

namespace mda {

/// Yes for at most two dimensions: one scan with fixed tracks, or two scans or sensors without.
[[nodiscard]] Verdict takes_one_scan(const Shape& shape);

/// What a row costs, nats, when no column of several rows uses it, and the column that does it.
struct Rest {
  double cost = 0.0;
  int column = kNoColumn;  ///< nothing, at no cost
};

/// Per row the cheapest column that uses it alone; for a row that is at most once only if that
/// costs less than nothing. An exactly-once row without such a column costs infinity. Of equal
/// columns the first. O(columns).
[[nodiscard]] std::vector<Rest> rests_of(const AssociationProblem& problem);

}  // namespace mda
