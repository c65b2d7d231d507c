// First-order steps on the LP relaxation of one component: on the columns' values and on the rows'
// multipliers at once.
#pragma once

#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/relaxation/normal_form.h"

namespace mda {

struct PrimalDualOptions {
  /// Weight of the sum of x^2 / 2, in the component's unit of cost; not negative. With 0 the steps
  /// extrapolate, without which they would not settle.
  double alpha = 0.0;
  double step = 0.5;        ///< share of the largest step that settles
  double tolerance = 1e-4;  ///< see primal_dual()
  int iterations = 20000;   ///< at most
};

/// In the component's unit of cost.
struct PrimalDualResult {
  std::vector<double> x;           ///< per column, not negative
  std::vector<double> multiplier;  ///< per row, not negative: the best found
  double bound = 0.0;              ///< what they prove
  int iterations = 0;
  Stop stop = Stop::kFinished;
};

/// With A the rows of the component, c its costs, and x, mu not negative:
///   alpha > 0:  x <- x - dt_x (c + alpha x + A'mu),   mu <- mu + dt_mu (A x - 1),
/// both sides of the step before: the iteration of Lee and Jeong (mapada) on any window. It settles
/// for dt_x < 2 / alpha, dt_mu < alpha / |A|^2. Their one dt for both is the smaller of the two,
/// and costs as much as the unit of cost is far from that in which both agree. It ends when no
/// change exceeds tolerance times its step. The limit is the optimum of c x + alpha/2 x^2, so the
/// bound stays below that of the relaxation, by alpha per row at most.
///   alpha = 0:  x <- x - dt (c + A'mu),   mu <- mu + dt (A (2 x - x before) - 1),   dt < 1 / |A|:
/// Chambolle and Pock, "A first-order primal-dual algorithm for convex problems with applications
/// to imaging" (2011), algorithm 1. It ends when no row is used more than 1 + tolerance times and c
/// x exceeds the bound by at most tolerance times max(1, |c x|): in the limit x is an optimum of
/// the relaxation. O(iterations * nonzeros). After the deadline it ends soon, with the best bound
/// so far.
[[nodiscard]] PrimalDualResult primal_dual(const NormalComponent& component,
                                           const PrimalDualOptions& options, const Budget& budget);

/// |A|^2, the largest eigenvalue of A A', by power iteration. At most 1 % too large, unless that
/// takes more than 100 iterations, and never too small: A A' is not negative, so the largest growth
/// of any entry of a positive vector bounds its eigenvalues (Collatz). O(nonzeros).
[[nodiscard]] double squared_norm(const NormalComponent& component);

}  // namespace mda
