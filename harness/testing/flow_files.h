// Texts of random flow problems in both dialects.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mda::testing {

/// The lines of a file before they are put in an order.
struct FlowLines {
  int nodes = 0;
  struct Node {
    int number;  ///< from 0
    std::int64_t supply;
  };
  std::vector<Node> supplies;
  struct Arc {
    int tail;  ///< from 0
    int head;
    std::string rest;  ///< what follows the nodes' numbers
  };
  std::vector<Arc> arcs;
};

/// At most 12 nodes without cycles: costs from -10 to 10 in steps of 2^-10, ties included.
[[nodiscard]] FlowLines random_tracking_lines(std::uint64_t seed);

/// At most 10 nodes: cycles, parallel arcs, lower bounds, negative costs; many are infeasible.
[[nodiscard]] FlowLines random_dimacs_lines(std::uint64_t seed);

/// As they stand.
[[nodiscard]] std::string text_of(const FlowLines& lines);

/// The nodes renumbered and the arc lines in another order; the
/// `n` lines keep theirs.
[[nodiscard]] FlowLines reordered(const FlowLines& lines, std::uint64_t seed);

}  // namespace mda::testing
