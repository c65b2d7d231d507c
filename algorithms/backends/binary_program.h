// Linear programs in binary variables, or their relaxations, by COIN-OR Clp and CBC.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/backends/run.h"

namespace mda {

/// min c x subject to row_lower <= A x <= row_upper, x binary. Add all rows first.
struct BinaryProgram {
  struct Entry {
    int row;
    double coefficient;
  };

  std::vector<double> row_lower;
  std::vector<double> row_upper;
  std::vector<double> costs;
  // A by columns: those of variable j are entries begins[j] up to, but without, begins[j + 1].
  std::vector<int> begins = {0};
  std::vector<int> rows;
  std::vector<double> coefficients;

  /// Returns the new row's number, counted from 0. Infinite: no bound.
  int add_row(double lower, double upper);

  /// Returns the new variable's number, counted from 0. The entries name different rows.
  int add_variable(double cost, std::span<const Entry> entries);
};

struct BinaryResult {
  Outcome outcome = Outcome::kDeadline;
  /// One value in [0, 1] per variable: an optimum, 0 or 1 unless of the relaxation; at the deadline
  /// the best point found, or empty.
  std::vector<double> x;
  int lp_fractional = 0;        ///< values of the relaxation's optimum that are not whole
  std::int64_t iterations = 0;  ///< of the simplex method
  std::int64_t nodes = 0;       ///< of branch and bound; 0 when the relaxation was whole
};

enum class Integrality : std::uint8_t { kBinary, kRelaxed };

/// Solves the relaxation by the dual simplex method and branches only if its optimum is not whole.
/// Stops soon after the deadline. Exponential in the worst case. Throws std::runtime_error if Clp
/// or CBC gives up.
[[nodiscard]] BinaryResult solve_program(const BinaryProgram& program, Integrality integrality,
                                         const Budget& budget);

}  // namespace mda
