// Multi-scan association as a flow of several commodities.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Every track is a commodity with a layered graph of its own, whose estimates come from its own
/// sequences (ties by cumulative cost); a plot may be used once by all of them together. The binary
/// program is solved by Clp, and by CBC when the relaxation is fractional. The costs of two scans
/// are exact, hence so is the answer for K <= 2; beyond, a node's estimate stands for all sequences
/// that end there. Exponential in the worst case. Needs the hypothesis tree and known tracks.
/// Source: Battistelli et al. 2008, sections I and II, as they describe their reference [3].
[[nodiscard]] std::unique_ptr<Associator> make_mcf();

/// The relaxation of that program alone. A fractional optimum is split into paths, track by track,
/// and rounded: the heaviest path first (ties: the cheapest) if its track and all its plots are
/// free; the tracks that are left miss every scan. The rounding is ours.
[[nodiscard]] std::unique_ptr<Associator> make_mcf_lp();

}  // namespace mda
