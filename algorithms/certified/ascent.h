// Dual coordinate ascent over the rows, with the least reduced cost of every tree.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/certified/pricing.h"

namespace mda {

struct AscentResult {
  std::vector<Steps> prices;  ///< the best found, one per row of the packing, not negative
  Steps bound = 0;            ///< what they prove
  std::vector<int> choice;    ///< the cheapest found, columns of the packing
  Steps cost = 0;             ///< of the choice; 0 for the empty one
  int rounds = 0;
  bool expired = false;  ///< the deadline came first

  [[nodiscard]] bool closed() const { return cost - bound < kGrid; }
};

/// Raises L(y) one row at a time. With all else fixed, L as a function of y_r is concave and
/// piecewise linear; it is largest between the largest and the second largest of the prices at
/// which the trees that use r would give it up, and takes the middle. Sweeps over a working set of
/// columns that are nearly their tree's best alternate with pricing all of them, and with a greedy
/// choice that takes columns of reduced cost 0 or less. Stops when bound and choice meet, or the
/// bound hardly moves. O(rounds * (nonzeros + trees per row * columns per tree)). Source:
/// coordinate ascent on the clique cover relaxation, as Haller and Savchynskyy 2024 (arXiv
/// 2408.02086) without their smoothing; relaxing all rows, Banerjee et al. 2004 (US 6704692).
class DualAscent {
 public:
  /// Keeps buffers between calls, nothing else.
  [[nodiscard]] AscentResult run(const Packing& packing, const Budget& budget);

 private:
  void start(const Packing& packing);
  void widen_working_set();
  void index_working_set();
  void sweep(int sweeps);
  void improve(int row);
  [[nodiscard]] bool is_settled(int row) const;
  void move_price(int row, Steps price);
  void choose_greedily(AscentResult& result);

  /// The columns of one tree that use a row: positions_[first] up to, but without, [last].
  struct Group {
    int tree;
    int first;
    int last;
  };

  const Packing* packing_ = nullptr;
  std::vector<Steps> prices_;
  Pricing pricing_;
  Steps band_ = 0;  ///< how far above its tree's best a column may be to join the working set
  std::vector<char> in_set_;
  // The working set, tree by tree; and for every row its groups.
  std::vector<int> column_;
  std::vector<Steps> reduced_;
  std::vector<int> tree_begin_;
  std::vector<int> row_begin_;  // of positions_
  std::vector<int> positions_;
  std::vector<int> group_begin_;
  std::vector<Group> groups_;
  // A row needs no second look until a tree of its has changed.
  std::int64_t time_ = 0;
  std::vector<std::int64_t> tree_changed_;
  std::vector<std::int64_t> row_visited_;
  bool upwards_ = true;
};

}  // namespace mda
