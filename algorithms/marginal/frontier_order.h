// In which order the rows of one side of a cluster are best processed, when the other side's rows
// are masked only between the first and the last row that they have a pair with.
#pragma once

#include <vector>

#include "algorithms/marginal/scan_weights.h"

namespace mda {

/// The pairs of a cluster by layer, a row of one side (a plot, say); the other side's rows are bits
/// of a mask. A bit with one pair only is private to that layer and never in the mask.
struct Incidence {
  std::vector<int> layer_begin;  ///< entries of layer l: layer_begin[l] up to layer_begin[l + 1]
  std::vector<int> bit;          ///< per entry
  std::vector<int> pair;         ///< per entry: of the cluster
  std::vector<int> bit_begin;    ///< layers of bit b: bit_begin[b] up to bit_begin[b + 1]
  std::vector<int> layer_of_bit;

  [[nodiscard]] int layers() const noexcept { return static_cast<int>(layer_begin.size()) - 1; }
  [[nodiscard]] int bits() const noexcept { return static_cast<int>(bit_begin.size()) - 1; }
  [[nodiscard]] bool is_private(int b) const {
    const auto i = static_cast<std::size_t>(b);
    return bit_begin[i + 1] - bit_begin[i] == 1;
  }
};

/// Masks the cluster's tracks if `mask_tracks`, else its plots. O(pairs).
[[nodiscard]] Incidence incidence_of(const Cluster& cluster, bool mask_tracks);

struct FrontierOrder {
  std::vector<int> layers;
  int width = 0;      ///< most bits in the mask at one time
  double work = 0.0;  ///< multiplications: sum over the layers of 3 (pairs + 1) 2^width
};

/// The cheapest of some greedy orders: from a start, always the layer that opens least bits beyond
/// those it closes among the layers that touch the frontier, and the nearest to the start among
/// those. (Without the rule that it must touch the frontier, several frontiers grow side by side:
/// on gated strips that took 5 to 20 bits more.) The first two starts are the ends of a long
/// cluster. O(layers^2 + pairs * pairs per bit) per start; at most 8 starts, 2 for very many
/// layers. The layers of the cluster must be connected.
[[nodiscard]] FrontierOrder find_frontier_order(const Incidence& incidence);

}  // namespace mda
