#include "algorithms/backends/run.h"

namespace mda {

Solution no_answer(Outcome outcome) {
  Solution solution;
  if (outcome == Outcome::kDeadline) solution.stop = Stop::kDeadline;
  if (outcome == Outcome::kInfeasible) {
    solution.note = "proven: no choice of columns fills every exactly-once row";
  }
  return solution;
}

}  // namespace mda
