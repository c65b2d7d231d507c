// Exact marginals of one cluster: a sum over all events by dynamic programming on the frontier.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/marginal/frontier_plan.h"

namespace mda {

/// With F_l[S] the weight of all that layers before l may do so that the masked bits S are taken,
/// and B_l[S] that of all that layers from l on may do then,
///     F_{l+1}[S] = a_l F_l[S] + sum over t in S of w_lt F_l[S - t]
///     B_l[S]     = a_l B_{l+1}[S] + sum over t not in S of w_lt B_{l+1}[S + t]
///     P(l, t)    = w_lt (sum over S without t of F_l[S] B_{l+1}[S + t]) / Z,
/// where Z is the same sum over all that layer l may do. All terms are positive: there is no
/// cancellation. Every ceil(sqrt(layers)) layers F is kept, rescaled by a power of 2, and computed
/// anew from there on the way back.
///
/// O(sum over the layers of (pairs + 1) 2^width) time. Source: the definition of the sum over
/// events; the recursion is derived from it.
class FrontierSum {
 public:
  explicit FrontierSum(const FrontierKernel& kernel) : kernel_(kernel) {}

  /// Memory that solve() needs, and keeps for the next call.
  [[nodiscard]] static double bytes(int layers, int width);

  /// Writes the probability of every pair; false after the deadline, which it sees once per layer.
  /// Masks of kMostFrontierBits at most.
  [[nodiscard]] bool solve(const std::vector<FrontierStep>& steps, const Budget& budget,
                           std::span<double> probability);

 private:
  struct FreeAligned {
    void operator()(double* values) const noexcept;
  };

  void make_room(const std::vector<FrontierStep>& steps);
  [[nodiscard]] double* slab(int number) const {
    return values_.get() + slab_size_ * static_cast<std::size_t>(number);
  }
  void advance(const std::vector<FrontierStep>& steps, int step, const double* from,
               double* to) const;
  void retreat(const FrontierStep& step, int step_number, const double* before,
               std::span<double> probability);

  const FrontierKernel& kernel_;
  std::unique_ptr<double[], FreeAligned> values_;
  std::size_t room_ = 0;  ///< of values_
  std::size_t slab_size_ = 0;
  double* ahead_ = nullptr;  ///< B after the step at hand
  double* spare_ = nullptr;
  LayerSums sums_;
};

}  // namespace mda
