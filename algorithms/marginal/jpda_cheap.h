// Fitzgerald's ad hoc formula for joint probabilistic data association.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// With w_tj the weight of a pair when free rows weigh 1, S_t the sum over the track's plots and
/// S_j that over the plot's tracks,
///     beta_tj = w_tj / (1 + S_t + S_j - w_tj),
/// the rest of every track is its probability of no plot. `pda` for a track without rivals.
/// Consistent: S_t >= w_tj, so the probabilities of a plot add up to S_j / (1 + S_j) at most.
/// O(nonzeros). Source: Fitzgerald, "Development of practical PDA logic for multitarget tracking
/// by microprocessor", American Control Conference (1986); his constant for clutter and misses is
/// the 1 here.
[[nodiscard]] std::unique_ptr<Associator> make_jpda_cheap();

}  // namespace mda
