// The steps of the dynamic programme on a frontier, with their weights.
#pragma once

#include <span>
#include <vector>

#include "algorithms/marginal/frontier_kernel.h"
#include "algorithms/marginal/frontier_order.h"

namespace mda {

/// Weights of a cluster whose rows are layers and bits.
struct FrontierWeights {
  std::span<const double> pair;
  std::span<const double> free_layer;  ///< of a layer that is in no pair
  std::span<const double> free_bit;
};

/// A layer takes a bit of the mask.
struct MaskedPair {
  int slot;  ///< place of the bit in the mask
  int pair;  ///< of the cluster
};

/// A layer takes a bit that no other layer wants.
struct PrivatePair {
  double weight;
  int pair;
};

/// A bit leaves the mask, and those above it move down.
struct Closing {
  int slot;
  double free;  ///< weight of the bit if nothing has taken it
};

/// One layer: `opened` bits join the mask above the others, the weights apply, and some bits leave,
/// those higher up first. `weights.none` counts the private pairs.
struct FrontierStep {
  LayerWeights weights;
  int width = 0;  ///< bits in the mask while the weights apply
  int opened = 0;
  std::vector<MaskedPair> pairs;
  std::vector<PrivatePair> privates;
  std::vector<Closing> closings;
};

/// O(sum over the layers of width + pairs).
[[nodiscard]] std::vector<FrontierStep> plan_frontier(const Incidence& incidence,
                                                      const FrontierOrder& order,
                                                      const FrontierWeights& weights);

}  // namespace mda
