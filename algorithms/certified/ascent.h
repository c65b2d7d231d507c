// Dual coordinate ascent over the rows, with the least reduced cost of every tree.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/certified/pricing.h"
#include "algorithms/certified/working_set.h"

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
/// which the trees that use r would give it up, and takes a price between them. Sweeps over a
/// working set of columns that are nearly their tree's best alternate with pricing all of them, and
/// with a greedy choice that takes columns of reduced cost 0 or less. Stops when bound and choice
/// meet, or the bound hardly moves. O(rounds * (nonzeros + trees per row * columns per tree)).
/// Source: coordinate ascent on the clique cover relaxation, as Haller and Savchynskyy 2024 (arXiv
/// 2408.02086) without their smoothing; relaxing all rows, Banerjee et al. 2004 (US 6704692).
class DualAscent {
 public:
  /// Gives up after so many rounds in a row that gain next to nothing: early where other stages
  /// come after it.
  explicit DualAscent(int patience = 2) : patience_(patience) {}

  /// Keeps buffers between calls, nothing else.
  [[nodiscard]] AscentResult run(const Packing& packing, const Budget& budget);

 private:
  void start(const Packing& packing);
  void widen_working_set();
  void move_to_the_middle();
  void sweep();
  void improve(int row);
  void move_price(int row, Steps price);
  void price_changed_trees();
  void price_tree(int tree);
  void choose_greedily(AscentResult& result);
  [[nodiscard]] int best_that_fits(int tree) const;

  int patience_;
  const Packing* packing_ = nullptr;
  LinkFinder link_finder_;
  Links links_;
  WorkingSet set_;
  Steps band_ = 0;  ///< how far above its tree's best a column may be to join the working set
  std::vector<Steps> prices_;
  Pricing pricing_;
  std::vector<Steps> path_price_;  // per node of the links
  // Of the trees, those whose prices have changed since they were priced.
  std::vector<char> is_changed_;
  /// Where a tree gives a row up, and when that was found.
  struct Limit {
    Steps price;
    std::int64_t time;
  };
  std::vector<Limit> limits_;  // per link
  std::int64_t time_ = 0;      // counts changes of prices
  std::vector<std::int64_t> tree_changed_;
  bool upwards_ = true;
  bool in_the_middle_ = false;
  // Of the greedy choice.
  std::vector<char> used_;
  std::vector<int> choice_;
};

}  // namespace mda
