// The one shape of every association problem (results/README.md lists the words used):
//
//     minimise  sum_j c_j x_j   over x in {0,1}^columns,
//     where every row is used at most once, or exactly once, and all coefficients are 1.
//
// A column is a possible track (a sequence of plots, perhaps continuing a fixed track); a row is a
// plot or a fixed track. Costs are in nats: minus the log likelihood ratio against "all of it is
// clutter", so an unused plot costs nothing and needs no column.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/api/views.h"

namespace mda {

enum class RowUse : std::uint8_t { kAtMostOnce, kExactlyOnce };

/// Facts about a problem that an algorithm may need before it accepts it.
struct Shape {
  int rows = 0;
  int columns = 0;
  int nonzeros = 0;
  int dimensions = 0;  ///< K + 1 with fixed tracks, K without
  int components = 0;  ///< of the row-column graph; rows without columns do not count
  int largest_component_columns = 0;
  bool has_exactly_once_rows = false;
  bool always_feasible = true;  ///< every exactly-once row has a column that touches it alone
  bool known_tracks = true;     ///< every column continues a fixed track: no births
  bool has_tree = false;        ///< the window came with its HypothesisTree
  bool has_pairs = false;       ///< the window came with its PairView
  bool has_sensors = false;     ///< the window came with its SensorView
  /// Every choice that breaks no row can be completed to one that fills them all: all rows are
  /// exactly-once, as many in every dimension, and any row of each makes a column (dense axial).
  bool is_axial = false;
};

/// Compressed columns, immutable once built; construct with ProblemBuilder. Safe to share between
/// threads.
class AssociationProblem {
 public:
  /// The problem with no rows and no columns.
  AssociationProblem() = default;

  [[nodiscard]] int rows() const noexcept { return static_cast<int>(row_use_.size()); }
  [[nodiscard]] int columns() const noexcept { return static_cast<int>(costs_.size()); }
  [[nodiscard]] int nonzeros() const noexcept { return static_cast<int>(row_indices_.size()); }

  /// Dimension 0 is reserved for fixed tracks, 1..K for the scans (or sensors), oldest first.
  [[nodiscard]] int dimension(int row) const { return row_dimension_[index(row)]; }
  [[nodiscard]] RowUse use(int row) const { return row_use_[index(row)]; }

  /// Nats.
  [[nodiscard]] double cost(int column) const { return costs_[index(column)]; }

  /// Rows that `column` uses, ascending, at least one.
  [[nodiscard]] std::span<const int> rows_of(int column) const {
    const auto begin = index(column_begins_[index(column)]);
    return {row_indices_.data() + begin, index(column_begins_[index(column) + 1]) - begin};
  }

  // The flat arrays, for solvers that load them at once.
  [[nodiscard]] std::span<const double> costs() const noexcept { return costs_; }
  [[nodiscard]] std::span<const int> column_begins() const noexcept { return column_begins_; }
  [[nodiscard]] std::span<const int> row_indices() const noexcept { return row_indices_; }

  [[nodiscard]] const Shape& shape() const noexcept { return shape_; }

  /// Component number (from 0, in the order of their first column) of every column.
  [[nodiscard]] std::span<const int> component_of_column() const noexcept { return component_; }

  /// The views of this window, or nullptr. They are no part of the problem's identity.
  [[nodiscard]] const Views* views() const noexcept { return views_.get(); }

  /// Hands the views over; copies of the problem share them.
  void attach(std::shared_ptr<const Views> views) {
    views_ = std::move(views);
    shape_.has_sensors = views_ != nullptr && views_->sensors.has_value();
    shape_.has_tree = views_ != nullptr && !shape_.has_sensors;
    shape_.has_pairs = views_ != nullptr && views_->pairs.has_value();
  }

  /// 16 hexadecimal digits over the structure and the costs rounded to 2^-20 nats: results of
  /// problems with different fingerprints are never compared. O(nonzeros).
  [[nodiscard]] std::string fingerprint() const;

 private:
  friend class ProblemBuilder;
  static constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

  std::vector<RowUse> row_use_;
  std::vector<int> row_dimension_;
  std::vector<double> costs_;
  std::vector<int> column_begins_ = {0};
  std::vector<int> row_indices_;
  std::vector<int> component_;
  Shape shape_;
  std::shared_ptr<const Views> views_;
};

/// Collects rows, then columns, and hands over a checked problem.
class ProblemBuilder {
 public:
  /// Throws away everything, keeps the memory.
  void clear();

  /// Returns the new row's number, counted from 0.
  int add_row(int dimension, RowUse use);

  /// Returns the new column's number, counted from 0. `rows` in any order.
  int add_column(double cost, std::span<const int> rows);

  [[nodiscard]] int rows() const noexcept { return static_cast<int>(row_use_.size()); }
  [[nodiscard]] int columns() const noexcept { return static_cast<int>(costs_.size()); }

  /// How many dimensions the problem has; by default, as many as its rows name.
  void set_dimensions(int dimensions) { dimensions_ = dimensions; }

  /// Throws std::invalid_argument, naming the row or column, when a row has a negative dimension,
  /// or a column has a cost that is not finite, no row, an unknown row, or two rows of one
  /// dimension. O(nonzeros), up to the sorting of each column's rows. Leaves the builder as it was.
  [[nodiscard]] AssociationProblem build() const;

 private:
  std::vector<RowUse> row_use_;
  std::vector<int> row_dimension_;
  std::vector<double> costs_;
  std::vector<int> column_begins_ = {0};
  std::vector<int> row_indices_;
  int dimensions_ = -1;
};

/// The coasting cost of every row: the least cost, at most 0, of a column that uses the row alone
/// if the row is a fixed track (dimension 0), and 0 for plots. Nats. O(columns).
[[nodiscard]] std::vector<double> coasting_costs(const AssociationProblem& problem);

}  // namespace mda
