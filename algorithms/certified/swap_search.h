// Local search by swaps on a choice of columns.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/certified/pricing.h"

namespace mda {

/// Swap: put a column in, take out what shares a row with it, and fill the rows that became free. A
/// descent makes all swaps that gain; a kick makes one that does not, descends, and goes back
/// unless the whole gained.
///
/// Prices tell where it is worth looking: what a choice costs beyond the bound is the sum of its
/// columns' reduced costs and its free rows' prices, so a swap must take out, or cover, more of
/// that than the new column brings. Columns are tried in the order of their reduced costs. Source:
/// the usual (omega, 1)-swaps of weighted independent set; the guidance is ours.
class SwapSearch {
 public:
  /// Candidates are the columns whose reduced cost is at most `band` above 0 or their tree's least.
  /// `prices` are folded into the roots.
  SwapSearch(const Packing& packing, std::vector<Steps> prices, const Pricing& pricing, Steps band);

  /// Begins with the columns of `choice`, in their order as far as they fit, and fills the rows
  /// that they leave free. They need not be candidates.
  void start(std::span<const int> choice);

  /// A descent, then `kicks` of them; stops at the deadline. A kick touches the neighbourhood of a
  /// column only.
  void improve(int kicks, const Budget& budget);

  [[nodiscard]] const std::vector<int>& choice() const noexcept { return choice_; }
  [[nodiscard]] Steps cost() const noexcept { return cost_; }

 private:
  [[nodiscard]] bool fits(int column) const;
  [[nodiscard]] bool may_gain(int column) const;
  void put(int column);
  void take(int column);
  /// Returns whether it gained; if it did not and it need not, everything is as before.
  bool swap(int column, bool even_at_a_loss);
  void fill(std::size_t moved_before);
  void descend();
  void undo(std::size_t moves_to_keep);
  void collect_choice();

  const Packing& packing_;
  std::vector<Steps> prices_;
  std::vector<Steps> excess_;    // per column, its reduced cost above the least
  std::vector<int> candidates_;  // by reduced cost
  std::vector<int> row_begin_;   // of by_row_
  std::vector<int> by_row_;      // candidates of every row, by reduced cost
  std::vector<int> owner_;       // per row, the column that uses it, or -1
  std::vector<char> chosen_;     // per column
  std::vector<int> choice_;
  Steps cost_ = 0;
  std::vector<int> stale_;  // rows whose candidates are worth another try
  std::vector<char> is_stale_;
  struct Move {
    int column;
    bool put;
  };
  std::vector<Move> moves_;
};

}  // namespace mda
