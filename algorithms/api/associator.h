// The one interface: every association algorithm is an Associator, listed in algorithms/catalog.cc.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "algorithms/api/problem.h"
#include "algorithms/api/solution.h"

namespace mda {

/// What an algorithm promises; algorithms/testing/contract.h turns each promise into laws.
struct Traits {
  Answer answer = Answer::kSelection;
  bool exact = false;          ///< a finished run is optimal for its own question
  bool bounds = false;         ///< claims lower bounds
  bool certifies = false;      ///< hands over row multipliers for its bound
  bool randomized = false;     ///< draws from Budget::seed
  bool needs_tree = false;     ///< works on the problem's HypothesisTree
  bool needs_pairs = false;    ///< works on the problem's PairView
  bool needs_sensors = false;  ///< works on the problem's SensorView
  /// Of marginals: the probabilities of a plot's tracks add up to 1 at most.
  bool consistent = false;

  [[nodiscard]] bool needs_views() const noexcept {
    return needs_tree || needs_pairs || needs_sensors;
  }
};

using Clock = std::chrono::steady_clock;

/// What a solve may use.
struct Budget {
  Clock::time_point deadline = Clock::time_point::max();
  std::uint64_t seed = 1;

  [[nodiscard]] bool expired() const { return Clock::now() >= deadline; }
  /// Seconds left, not negative; infinity without a deadline.
  [[nodiscard]] double seconds_left() const;
};

/// "No" with a reason becomes a skipped row.
struct Verdict {
  bool ok = true;
  std::string reason;
};

class Associator {
 public:
  Associator() = default;
  Associator(const Associator&) = delete;
  Associator& operator=(const Associator&) = delete;
  virtual ~Associator() = default;

  [[nodiscard]] virtual Traits traits() const noexcept = 0;

  /// Whether the algorithm takes problems of this shape. By default it takes all that are always
  /// feasible.
  [[nodiscard]] virtual Verdict can_solve(const Shape& shape) const;

  /// Solves one problem for which can_solve() said yes. Keeps buffers between calls, never
  /// information: solve(A), solve(B), solve(A) repeats A. Not thread safe: one object per thread.
  /// After the deadline it returns soon, with the best it has; it may throw on its own bugs.
  [[nodiscard]] virtual Solution solve(const AssociationProblem& problem, const Budget& budget) = 0;
};

}  // namespace mda
