// Assignment in many dimensions as a sequence of assignments in two.
#pragma once

#include <span>
#include <vector>

#include "algorithms/backends/pair_selection.h"
#include "algorithms/relaxation/normal_form.h"

namespace mda {

/// The relaxed problem's optimum for given multipliers.
struct RelaxedOptimum {
  double bound = 0.0;              ///< L(u), in the component's unit
  std::vector<double> multiplier;  ///< u with the prices of the first two levels: proves the bound
  std::vector<int> usage;          ///< per row, how many of the chosen columns use it
  std::vector<int> columns;        ///< chosen
};

/// One component, taken apart by levels. Rows of the first two levels hold as they are; those of
/// the others have prices. O(nonzeros) and an assignment for every level.
class StagedAssignment {
 public:
  explicit StagedAssignment(const NormalComponent& component);

  /// `u`: per row, not negative; those of the first two levels are ignored. For every pair of rows
  /// of the first two levels the cheapest column is what counts (Poore and Rijavec 1993).
  const RelaxedOptimum& relax(std::span<const double> u);

  /// Places the levels after the second one by one after relax(u): the groups of rows chosen so far
  /// are assigned to the rows of the next level, the levels after it still have their prices u. The
  /// columns of a choice that breaks no row.
  [[nodiscard]] std::vector<int> recover(std::span<const double> u);

 private:
  static constexpr int kNoGroup = -1;  ///< uses no row of the levels placed
  static constexpr int kOut = -2;      ///< its rows of the levels placed are no chosen group

  [[nodiscard]] int row_at(int column, int level) const;
  void start(std::span<const double> u);
  const PairSelection& choose(int level);
  void regroup(int level, const PairSelection& selection);

  const NormalComponent& component_;
  int levels_;
  std::vector<int> level_begin_;
  std::vector<int> row_at_;  ///< [column * levels + level]: number in the level, or kNone
  PairSelector selector_;
  PairProblem pairs_;
  std::vector<int> column_of_option_;
  int groups_ = 0;
  std::vector<int> group_;         ///< per column
  std::vector<double> price_;      ///< per column: cost with the prices of the levels to come
  std::vector<int> next_group_;    ///< per old group, then per row of the level
  std::vector<int> row_of_group_;  ///< per old group, of the level
  RelaxedOptimum relaxed_;
};

}  // namespace mda
