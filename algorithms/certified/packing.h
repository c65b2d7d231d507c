// A window in whole numbers: the form that every stage of the certified solver works on.
//
//     minimise  sum_j c_j x_j   over x in {0,1}^columns,  every row used at most once,  c_j < 0
//
// Columns are grouped into trees: those of a tree share its root row, so that at most one of them
// is chosen. The tree is what keeps the dual small: with prices y >= 0 on the rows,
//
//     L(y) = sum_t min(0, min_{j in t} (c_j + sum_{r in j} y_r)) - sum_r y_r
//
// is a lower bound, and a root that no other tree uses needs no price.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/api/problem.h"
#include "algorithms/api/solution.h"

namespace mda {

/// Costs, prices and bounds are whole numbers of steps: sums are exact, whatever their order.
using Steps = std::int64_t;

/// Costs are multiples of it, prices need not be: a bound less than this below the cost of a choice
/// proves that there is none better.
inline constexpr Steps kGrid = 1024;

/// The least multiple of kGrid that is not below `bound`: no choice that costs `bound` or more
/// costs less.
[[nodiscard]] constexpr Steps on_grid(Steps bound) noexcept {
  const Steps below = bound / kGrid * kGrid;
  return below < bound ? below + kGrid : below;
}

struct Packing {
  std::vector<int> tree_begin = {0};  ///< columns of tree t: from tree_begin[t]
  std::vector<int> root;              ///< per tree, the row that all its columns use
  std::vector<int> begin = {0};       ///< rows of column j: from begin[j], in no order
  std::vector<int> row;
  std::vector<Steps> cost;      ///< per column, negative multiples of kGrid
  std::vector<int> origin;      ///< per column, its number in the window
  std::vector<int> row_origin;  ///< per row, its number in the window

  [[nodiscard]] int rows() const noexcept { return static_cast<int>(row_origin.size()); }
  [[nodiscard]] int columns() const noexcept { return static_cast<int>(cost.size()); }
  [[nodiscard]] int trees() const noexcept { return static_cast<int>(root.size()); }
  [[nodiscard]] std::span<const int> rows_of(int j) const {
    const auto first = static_cast<std::size_t>(begin[static_cast<std::size_t>(j)]);
    const auto last = static_cast<std::size_t>(begin[static_cast<std::size_t>(j) + 1]);
    return {row.data() + first, last - first};
  }
};

/// What the choice of `columns` costs. O(columns chosen).
[[nodiscard]] Steps cost_of(const Packing& packing, std::span<const int> columns);

/// The window's numbers of `columns`.
[[nodiscard]] std::vector<int> origins_of(const Packing& packing, std::span<const int> columns);

/// A window as a packing, and the way back.
///
/// An exactly-once row is charged in advance for its cheapest column alone; then it is used at most
/// once like the others, and columns that are not negative any more are left out: replacing one by
/// the columns alone costs no more. Rows all of whose columns are in one tree say nothing that its
/// root does not, and are left out too.
struct WindowPacking {
  Packing packing;
  /// Costs are rounded to 2^-bits nats: bits = 34 - e, where the largest gain of a column is below
  /// 2^e nats, so that scaling all costs by a power of 2 changes nothing. 22 or more for gains up
  /// to 4,096 nats. Less where columns alone of exactly-once rows cost much beside it.
  int bits = 0;
  std::vector<Steps> charge;          ///< per row of the window; 0 on at-most-once rows
  std::vector<int> column_of_charge;  ///< per row of the window, or -1
  Steps charged = 0;                  ///< all of it
  int left_out = 0;                   ///< columns that gain nothing but, perhaps, by rounding

  [[nodiscard]] double nats(Steps steps) const;
  /// What a bound on the packing says about the window, nats: less all that rounding costs to
  /// multiples of 2^-bits can hide.
  [[nodiscard]] double bound_nats(Steps bound) const;
  /// The chosen columns of the window and those that fill exactly-once rows which they leave free.
  [[nodiscard]] std::vector<int> completed(const AssociationProblem& problem,
                                           std::span<const int> chosen) const;
  /// Multipliers of the window's rows that prove what prices of the packing's rows do.
  [[nodiscard]] std::vector<double> row_dual(std::span<const Steps> price) const;
};

/// What may be said of a choice (columns of the window) when `lower_bound` has been proven, nats:
/// that it is optimal, where the two differ by no more than costs may. Rounding can be too coarse
/// for that.
[[nodiscard]] Status status_of(const AssociationProblem& problem, std::span<const int> choice,
                               double lower_bound);

/// Makes windows packings, one after the other. Keeps buffers between calls, nothing else.
class Packer {
 public:
  /// Takes always feasible problems. Valid until the next call. The packing does not depend on the
  /// order of the problem's rows and columns as long as no two columns cost the same.
  /// O(nonzeros + rows log rows).
  [[nodiscard]] const WindowPacking& pack(const AssociationProblem& problem);

 private:
  struct Gain {
    int column;  ///< of the problem
    int root;    ///< row of the problem
    Steps cost;
  };
  /// A row as its columns that gain show it.
  struct RowFacts {
    Steps cheapest;  ///< of its columns
    int only_root;   ///< the root of all its columns, or none, or several
    int columns_as_root;
  };

  void find_charges(const AssociationProblem& problem);
  [[nodiscard]] double gain_of(const AssociationProblem& problem, int column) const;
  void choose_bits(const AssociationProblem& problem);
  void charge(const AssociationProblem& problem);
  void find_gains(const AssociationProblem& problem);
  void add_gain(const AssociationProblem& problem, int column, Steps cost);
  void order_rows(const AssociationProblem& problem);
  void number_rows_and_trees();
  void copy_columns(const AssociationProblem& problem);

  WindowPacking window_;
  std::vector<Gain> gains_;
  std::vector<RowFacts> facts_;  // per row of the problem
  struct RankedRow {
    int dimension;
    int row;
    Steps cheapest;
  };
  std::vector<RankedRow> ranked_;  // in the order
  std::vector<int> number_;        // per row of the problem, the number that it gets, or none
  std::vector<int> next_;          // per row that is a root, the place of its next column
  std::vector<int> order_;         // gains, tree by tree
};

/// A packing that is made once.
[[nodiscard]] WindowPacking pack(const AssociationProblem& problem);

}  // namespace mda
