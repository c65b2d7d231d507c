// The LP relaxation of an association problem, by the simplex method of COIN-OR Clp.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/backends/run.h"

class ClpSimplex;

namespace mda {

/// A value of a basic LP optimum within this distance of 0 or 1 counts as 0 or 1.
inline constexpr double kIntegralityTolerance = 1e-6;

[[nodiscard]] inline bool is_integral(double x) noexcept {
  return std::abs(x - std::round(x)) <= kIntegralityTolerance;
}

struct LpResult {
  Outcome outcome = Outcome::kInfeasible;
  std::vector<double> x;         ///< basic optimum, one per column, in [0, 1]; empty without one
  std::vector<double> row_dual;  ///< u, one per row, not negative on at-most-once rows
  /// L(u) = -sum_r u_r + sum_j min(0, c_j + sum_{r in j} u_r), nats: a lower bound for any such u,
  /// at an optimum equal to the cost of x up to rounding.
  double lower_bound = 0.0;
  std::int64_t iterations = 0;
  double translate_ms = 0.0;  ///< building Clp's model
};

/// Keeps its buffers between calls, nothing else. One object per thread.
class LpRelaxation {
 public:
  /// Stops soon after the budget's deadline (looked at in every simplex iteration). Throws
  /// std::runtime_error if Clp gives up.
  [[nodiscard]] LpResult solve(const AssociationProblem& problem, const Budget& budget);

 private:
  void load(const AssociationProblem& problem, ClpSimplex& model);

  std::vector<double> ones_;
  std::vector<double> row_lower_;
};

}  // namespace mda
