// Cuts, then branch and bound, on what reduced costs have left of a component.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/certified/branching.h"
#include "algorithms/certified/cut_lp.h"
#include "algorithms/certified/proof.h"

namespace mda {

struct SearchResult {
  bool complete = false;                   ///< before the deadline
  std::optional<std::vector<int>> choice;  ///< the cheapest found below the ceiling
  Steps floor = 0;  ///< no choice costs less: the choice's own cost or the ceiling, if complete
  int nodes = 0;
  std::int64_t iterations = 0;
};

/// At the root, rounds of odd-row and clique cuts, each followed by swaps from the rounded LP
/// point, recombination of what they ended at, and reduced-cost fixing, and a dive for choices.
/// Then depth first on pairs of rows that the LP gives to one column by halves: "one column uses
/// both, or none either" against "no column uses both". Where no pair moves anything, on a column.
/// Of some divisions, that whose sides raise the LP's value most, as far as a few steps of the
/// simplex told when they came up first.
/// Every node solves its LP by column generation and fixes columns for its subtree. Source:
/// zero-half and clique cuts as in cuts.h; branching after Ryan and Foster 1981.
class KernelSearch {
 public:
  /// For choices that cost less than `ceiling`; `prices` are folded into the roots.
  KernelSearch(const Part& part, Steps ceiling, const Budget& budget, Proof& proof);

  [[nodiscard]] SearchResult run();

 private:
  void cut_root();
  bool add_cuts();
  void dive();
  [[nodiscard]] std::vector<int> alive_columns() const;
  void visit();
  void branch();
  /// What the LP's value rises by on the sides of a division, LP units.
  struct Gains {
    double with;
    double without;
  };
  [[nodiscard]] Division best_division(const std::vector<int>& alive);
  Gains try_out(const Division& division);
  void visit_without(const std::vector<int>& columns);
  void close_without_rivals(const std::vector<int>& alive);
  /// False when the node needs no branching: it is closed, or time is over.
  bool solve_node(int kicks);
  void look_for_choices(int kicks);
  void offer(const std::vector<int>& choice);
  void recombine();
  [[nodiscard]] std::vector<int> fix_columns();
  void kill(const std::vector<int>& columns);
  void revive(const std::vector<int>& columns);
  void record_prices();

  const Packing& packing_;
  const Budget& budget_;
  Proof& proof_;
  CutLp lp_;
  Steps ceiling_;
  Steps root_bound_;
  std::vector<std::pair<int, double>> point_;
  std::vector<Steps> prices_;              // of the part, before all cuts
  std::vector<std::vector<int>> choices_;  // those that swaps ended at, the latest few
  std::map<RowPair, Gains> gains_;         // as they were where the pair came up first
  bool stopped_ = false;
  SearchResult result_;
};

}  // namespace mda
