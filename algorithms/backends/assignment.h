// Rectangular two-dimensional assignment by shortest augmenting paths.
#pragma once

#include <limits>
#include <utility>
#include <vector>

namespace mda {

/// Rows take at most one column each; a row that takes none costs alone[row] (infinity: it must
/// take one); columns are used at most once. Absent pairs are forbidden; costs are finite and of
/// any sign; a pair may be listed twice.
struct SparseCosts {
  int columns = 0;
  std::vector<int> row_begin;  ///< entries of row i: row_begin[i] up to row_begin[i + 1]
  std::vector<int> column;     ///< per entry
  std::vector<double> cost;    ///< per entry
  std::vector<double> alone;   ///< per row

  [[nodiscard]] int rows() const noexcept { return static_cast<int>(alone.size()); }
};

/// An optimal assignment with its dual prices:
///   column_price >= 0, row_price[i] <= cost_ij + column_price[j], row_price[i] <= alone[i].
/// For any such prices, sum row_price - sum column_price is a lower bound on the cost; for these it
/// equals the cost, up to rounding. Without a feasible assignment the cost is infinite, the prices
/// obey the inequalities and prove nothing.
struct Assignment {
  static constexpr int kAlone = -1;

  bool feasible = false;
  std::vector<int> column_of_row;  ///< or kAlone
  double cost = std::numeric_limits<double>::infinity();
  std::vector<double> row_price;
  std::vector<double> column_price;
};

/// Successive shortest augmenting paths in the manner of Jonker and Volgenant, "A shortest
/// augmenting path algorithm for dense and sparse linear assignment problems", Computing 38 (1987),
/// without their initial reductions. Deterministic; the order of rows, columns and entries moves
/// neither feasibility nor, up to rounding, the cost. O(rows * entries * log entries), in practice
/// near O(entries). Keeps buffers between calls, no information; one object per thread.
class AssignmentSolver {
 public:
  /// The result lives until the next call.
  const Assignment& solve(const SparseCosts& costs);

 private:
  static constexpr int kFree = -1;

  void reset(const SparseCosts& costs);
  bool insert(const SparseCosts& costs, int root);
  void relax(const SparseCosts& costs, int row, double offset);
  [[nodiscard]] int nearest_column();
  void raise_prices(double distance);
  void augment(int column);
  void forget_tree();
  void finish(const SparseCosts& costs);

  Assignment result_;
  std::vector<int> row_of_column_;
  std::vector<double> pair_cost_;  ///< per column: of the pair it is in
  // The search tree of the row being inserted. Distances include the price of the column.
  std::vector<double> distance_;
  std::vector<int> reached_from_;   ///< per column: the row before it
  std::vector<double> entry_cost_;  ///< per column: of the pair (reached_from_, column)
  std::vector<char> settled_;
  std::vector<int> touched_;
  std::vector<int> settled_columns_;
  std::vector<std::pair<double, int>> heap_;
  double best_alone_ = 0.0;
  int best_alone_row_ = kFree;
};

}  // namespace mda
