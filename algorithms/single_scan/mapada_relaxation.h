// The relaxation of Lee and Jeong: assignments of one cluster as real numbers, found by gradient
// steps on a Lagrangian.
#pragma once

#include <span>
#include <vector>

#include "algorithms/api/associator.h"

namespace mda {

/// One cluster in the paper's notation: m measurements j, n targets t = 1..n, and the clutter t =
/// 0. Target t takes exactly one measurement, every measurement has one origin, so m >= n. Pairs
/// that are not listed do not exist. Fill it measurement by measurement: its clutter, then its
/// targets.
struct MapadaCluster {
  int targets = 0;                    ///< n
  std::vector<int> pair_begin = {0};  ///< pairs of measurement j: from [j] up to [j + 1]
  std::vector<int> t;                 ///< per pair
  std::vector<double> c;              ///< per pair: its cost, 0 for clutter
  std::vector<double> gate;  ///< per pair: Omega_jt, 1 in the gate (clutter always), else 0

  /// m.
  [[nodiscard]] int measurements() const noexcept {
    return static_cast<int>(pair_begin.size()) - 1;
  }
  /// Measurement number m, with its clutter.
  void add_measurement();
  /// Of the newest measurement.
  void add_pair(int target, double cost, bool in_gate);
};

struct MapadaIteration {
  double alpha = 1.0;       ///< weight of the gate, in the unit of c; positive
  double step = 0.5;        ///< dt as a share of mapada_step_bound()
  double tolerance = 1e-4;  ///< it ends when all changes are less than this times dt
  int iterations = 5000;    ///< at most
  /// Whether omega stays at or above 0. If not, this is equation (16) as printed.
  bool clip = true;
};

/// The largest step for which equation (16) settles: min(2 / alpha, alpha / (m + n + 1)). The
/// constraints' matrix is the incidence matrix of a bipartite graph with parts of m and n + 1; the
/// square of its norm is m + n + 1 if the graph is complete, and otherwise less.
[[nodiscard]] double mapada_step_bound(double alpha, int measurements, int targets);

struct MapadaPoint {
  std::vector<double> omega;  ///< per pair, finite
  int iterations = 0;
  Stop stop = Stop::kFinished;  ///< kIterationLimit also where it has diverged
};

/// Equation (16), its bracket being dL/d omega and its sums those of the step before, on
///   L = sum c w + alpha/2 sum (w - Omega)^2 + sum_t lambda_t (sum_j w - s_t)
///       + sum_j epsilon_j (sum_t w - 1),   s_0 = m - n, s_t = 1.
/// The sum at alpha includes the clutter, which the paper's (13) leaves out and its (16) does not.
/// `start` (per pair, or empty: Omega with rows that add up to 1) does not move the limit.
/// O(iterations * pairs).
[[nodiscard]] MapadaPoint mapada_relaxation(const MapadaCluster& cluster,
                                            const MapadaIteration& options, const Budget& budget,
                                            std::span<const double> start = {});

/// The measurement of every target t, at [t - 1], by optimal assignment on -omega: no measurement
/// twice. For the limit without clipping that is an optimum of
///   sum c w + alpha/2 sum (1 - 2 Omega) w
/// over whole w, whatever alpha is, since c - alpha Omega + alpha omega is constant along rows and
/// columns. O(assignment). Throws std::invalid_argument if some target cannot have a measurement.
[[nodiscard]] std::vector<int> assign_by_omega(const MapadaCluster& cluster,
                                               std::span<const double> omega);

/// The measurement of the largest omega of every target, of several the first.
[[nodiscard]] std::vector<int> largest_omega(const MapadaCluster& cluster,
                                             std::span<const double> omega);

}  // namespace mda
