#include "algorithms/api/associator.h"

#include <algorithm>
#include <limits>

namespace mda {

double Budget::seconds_left() const {
  if (deadline == Clock::time_point::max()) return std::numeric_limits<double>::infinity();
  return std::max(0.0, std::chrono::duration<double>(deadline - Clock::now()).count());
}

Verdict Associator::can_solve(const Shape& shape) const {
  if (shape.always_feasible) return {};
  return {false, "it cannot promise to fill every exactly-once row of this problem"};
}

}  // namespace mda
