// A linear programme that grows by columns and rows and is solved again from where it stood, by
// COIN-OR Clp.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/backends/run.h"

namespace mda {

/// min c x subject to A x <= b, x >= 0, with b >= 0: doing nothing is feasible.
class GrowingLp {
 public:
  struct Entry {
    int at;  ///< the row of a new column, or the column of a new row
    double coefficient;
  };

  /// Rows 0 to `rows` - 1 have right-hand side 1.
  explicit GrowingLp(int rows);
  GrowingLp(const GrowingLp&) = delete;
  GrowingLp& operator=(const GrowingLp&) = delete;
  ~GrowingLp();

  /// The entries name different rows. New columns and rows get the next numbers; those of a batch
  /// reach Clp together, with the next solve.
  void add_column(double cost, std::span<const Entry> entries);
  void add_row(double right_hand_side, std::span<const Entry> entries);
  /// Those behind move up. Their slacks should be basic.
  void remove_rows(std::span<const int> rows);
  /// Those behind move up. They should be forbidden.
  void remove_columns(std::span<const int> columns);
  /// A forbidden column stays 0.
  void forbid(int column, bool forbidden);

  [[nodiscard]] int columns() const noexcept { return columns_; }
  [[nodiscard]] int rows() const noexcept { return rows_; }

  enum class Method : std::uint8_t {
    kPrimal,  ///< after new columns
    kDual     ///< after new rows, or columns that became forbidden
  };
  /// Stops soon after the deadline. Throws std::runtime_error if Clp gives up.
  [[nodiscard]] Outcome solve(Method method, const Budget& budget);
  /// What the value would be with `columns` forbidden as well, or a lower bound: the dual simplex
  /// takes `most_steps`. To be called when solved; value() stays, x() and the others are lost.
  [[nodiscard]] double value_without(std::span<const int> columns, int most_steps,
                                     const Budget& budget);
  // Of the last solve.
  [[nodiscard]] double value() const noexcept { return value_; }
  [[nodiscard]] std::span<const double> x() const;
  /// Not negative: the value falls by it per unit of right-hand side.
  [[nodiscard]] std::vector<double> multipliers() const;
  /// Whether the row does not bind.
  [[nodiscard]] bool is_slack(int row) const;
  [[nodiscard]] std::int64_t iterations() const noexcept { return iterations_; }

 private:
  class Model;
  void flush();

  std::unique_ptr<Model> model_;
  int rows_;
  int columns_ = 0;
  std::int64_t iterations_ = 0;
  double value_ = 0.0;
  // Columns that Clp does not have yet.
  std::vector<double> costs_;
  std::vector<int> begins_ = {0};
  std::vector<int> at_;
  std::vector<double> coefficients_;
};

}  // namespace mda
