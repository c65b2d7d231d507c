// Loopy belief propagation for the marginals of joint probabilistic data association.
#pragma once

#include <cstdint>
#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

struct LbpOptions {
  /// The messages' distance from their limit at which they stop, as a ratio minus 1, guaranteed by
  /// the contraction.
  double tolerance = 1e-6;
  std::int64_t most_iterations = 20000;
};

/// Approximate marginals for clusters of any size: tracks and plots exchange messages until these
/// stand still. Exact if the pairs of a cluster make no cycle. Converges always, but slowly if
/// tracks are sure to be detected and plots sure not to be clutter; at the limit of iterations the
/// last beliefs are the answer. Nearly consistent: a plot's probabilities add up to 1 at most in
/// the limit. O(pairs) per iteration. Source: Williams and Lau, "Approximate evaluation of marginal
/// association probabilities with belief propagation", IEEE Transactions on Aerospace and
/// Electronic Systems 50 (2014).
[[nodiscard]] std::unique_ptr<Associator> make_lbp(const LbpOptions& options);

}  // namespace mda
