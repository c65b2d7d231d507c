// From paths through a relaxation's graph to an answer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/api/problem.h"
#include "algorithms/api/solution.h"

namespace mda {

/// Collects what the tracks do. A sequence that is a column selects it. Relaxations that judge a
/// sequence by the costs of others may find one that no gate let through: if the problem's views
/// know what it costs, it is answered as it is (Solution::tuples), else repaired: at a step that
/// the tree lacks the track misses the scan instead, and if it may not do that either, it coasts.
/// Repairs use no plot that the sequence does not use.
class PathDecoder {
 public:
  /// `problem` has a tree and must outlive the decoder. O(rows).
  explicit PathDecoder(const AssociationProblem& problem);

  /// The fixed track follows this sequence. O(K x children of a node).
  void follow(const Tuple& tuple);

  /// The fixed track misses every scan, or is dropped if it may be and that costs less.
  void coast(int track);

  /// What coast() costs, nats.
  [[nodiscard]] double coasting_cost(int track) const;

  /// A track begins in the window; rows[k - 1]: its plot in scan k or kNoRow. What no repair helps
  /// is given up.
  void begin(std::span<const int> rows);

  /// What the columns and sequences so far amount to.
  [[nodiscard]] Solution answer() const;

 private:
  enum class Steps : std::uint8_t { kAsTheyAre, kRepaired };

  [[nodiscard]] int child(int node, int row) const;
  [[nodiscard]] int leaf(int root, std::span<const int> rows, Steps steps) const;
  [[nodiscard]] int coasting_leaf(int track) const;
  void take(int leaf);

  const AssociationProblem& problem_;
  const HypothesisTree& tree_;
  std::vector<int> root_of_row_;  ///< of fixed tracks, and of births by their first plot
  std::vector<int> chosen_;
  std::vector<Tuple> tuples_;
  int off_column_paths_ = 0;
};

}  // namespace mda
