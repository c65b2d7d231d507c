// The baseline that every other method should beat.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Goes once through the columns, ranked by what they gain over letting their fixed track coast
/// (cost minus coasting cost, see coasting_costs()), then by cost, then by number, and takes each
/// one whose rows are all free. Only columns that have a negative cost or use an exactly-once row
/// take part; so every exactly-once row that some column uses alone gets filled.
/// O(nonzeros + columns log columns). Source: none, the usual first idea.
[[nodiscard]] std::unique_ptr<Associator> make_greedy();

}  // namespace mda
