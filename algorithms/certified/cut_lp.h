// The LP of a packing with cuts and forbidden columns, by column generation: what every node of the
// search solves.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "algorithms/backends/growing_lp.h"
#include "algorithms/certified/cuts.h"
#include "algorithms/certified/pricing.h"

namespace mda {

class CutLp {
 public:
  /// Starts with the columns of least reduced cost of every row.
  CutLp(const Packing& packing, std::span<const Steps> reduced, const Budget& budget);

  void add(Cut cut);
  /// Takes cuts that do not bind at the last optimum out of the LP, for good.
  void drop_slack_cuts();
  void kill(int column);
  void revive(int column);
  /// Those that are dead now are never revived: they leave the LP and living().
  void bury_the_dead();
  /// Ascending: all columns but those that are buried.
  [[nodiscard]] const std::vector<int>& living() const noexcept { return living_; }
  [[nodiscard]] bool is_alive(int column) const {
    return alive_[static_cast<std::size_t>(column)] != 0;
  }
  [[nodiscard]] std::span<const char> alive() const { return alive_; }

  /// Solves over the columns that are alive, or until the bound tells that no choice costs less
  /// than `ceiling`.
  [[nodiscard]] Outcome solve(Steps ceiling);

  /// The value of the LP of the columns that have entered, of the last solve, in its own units.
  [[nodiscard]] double value() const { return lp_.value(); }
  [[nodiscard]] static double units(Steps cost) noexcept;
  /// That, with `columns` killed as well, or a lower bound: after `most_steps` of the simplex.
  [[nodiscard]] double value_without(std::span<const int> columns, int most_steps);

  // Of the last solve. Reduced costs are those with rows and cuts; dead columns have kDead.
  static constexpr Steps kDead = Steps{1} << 60;
  [[nodiscard]] const Pricing& pricing() const noexcept { return pricing_; }
  /// Least reduced cost in the column's tree, or 0 if that is more.
  [[nodiscard]] Steps least_beside(int column) const {
    const int tree = tree_of_column_[static_cast<std::size_t>(column)];
    return std::min<Steps>(0, pricing_.least[static_cast<std::size_t>(tree)]);
  }
  [[nodiscard]] Steps bound() const noexcept { return pricing_.bound; }
  /// Prices of rows, folded into the roots.
  [[nodiscard]] std::vector<Steps> row_prices() const;
  [[nodiscard]] const std::vector<Steps>& cut_prices() const noexcept { return cut_prices_; }
  /// Columns above 0.
  [[nodiscard]] std::vector<std::pair<int, double>> point() const;

  [[nodiscard]] int cuts() const noexcept { return static_cast<int>(cuts_.size()); }
  [[nodiscard]] const Cut& cut(int k) const { return cuts_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] std::int64_t iterations() const noexcept { return lp_.iterations(); }

 private:
  void enter(int column);
  void price_all();
  void find_bound(Steps paid);
  [[nodiscard]] bool enter_columns_that_gain();

  const Packing& packing_;
  const Budget& budget_;
  GrowingLp lp_;
  std::vector<int> lp_column_;  // per column, its number in the LP, or -1
  std::vector<int> column_of_lp_;
  std::vector<char> alive_;
  std::vector<int> living_;
  std::vector<int> tree_of_column_;
  std::vector<Cut> cuts_;
  std::vector<int> cut_of_lp_row_;  // of LP rows behind those of the packing
  std::vector<std::vector<std::pair<int, int>>> cuts_of_column_;  // of cuts in the LP
  std::vector<Steps> prices_;
  std::vector<Steps> cut_prices_;
  Pricing pricing_;
  std::vector<GrowingLp::Entry> entries_;
  GrowingLp::Method method_ = GrowingLp::Method::kPrimal;
};

}  // namespace mda
