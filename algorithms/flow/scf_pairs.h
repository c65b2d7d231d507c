// Multi-scan association as a flow, in windows where tracks are born.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// The single-commodity flow for the fixed tracks (ties by cumulative cost), and beside it a flow
/// of tracks that are born through pairs of successive plots. Rows that let every plot be used at
/// most once tie the two together, so this is no pure network: the program is solved by Clp, and by
/// CBC when its relaxation is fractional. Costs of sequences of at most two plots (births) or one
/// scan (fixed tracks) are exact, others those of the best partial paths. Exponential in the worst
/// case, in practice the relaxation is mostly whole. Needs the hypothesis tree, and that no row
/// must be used. Source: an extension of Battistelli et al. 2008, section III, whose tracks are all
/// known; ours.
[[nodiscard]] std::unique_ptr<Associator> make_scf_pairs();

}  // namespace mda
