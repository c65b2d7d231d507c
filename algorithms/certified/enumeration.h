// Every choice that prices do not rule out, on packings so small that an LP would take longer.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/certified/pricing.h"

namespace mda {

struct Enumeration {
  bool complete = false;  ///< within the limit of nodes and the deadline
  int nodes = 0;
  /// The cheapest choice below the ceiling; nothing: if complete, there is none.
  std::optional<std::vector<int>> choice;
};

/// With prices folded into the roots (pricing.h), what a choice costs beyond the bound is the sum
/// of its columns' reduced costs and its free rows' prices, all of them not negative. So: take the
/// row with the fewest affordable ways out, pay for each in turn, and stop where the money ends
/// that separates the bound from the ceiling.
[[nodiscard]] Enumeration enumerate(const Packing& packing, const std::vector<Steps>& prices,
                                    const Pricing& pricing, Steps ceiling, int most_nodes,
                                    const Budget& budget);

}  // namespace mda
