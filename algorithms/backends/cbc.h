// Branch and bound on an association problem, or on a part of one, by COIN-OR CBC.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/backends/run.h"

class ClpSimplex;

namespace mda {

struct CbcResult {
  Outcome outcome = Outcome::kDeadline;
  /// A choice of columns that breaks no row was found; at the deadline perhaps not.
  bool has_choice = false;
  std::vector<int> chosen;                                        ///< its columns, ascending
  double lower_bound = -std::numeric_limits<double>::infinity();  ///< proven, nats
  std::int64_t nodes = 0;
  std::int64_t iterations = 0;  ///< of the simplex method
  double translate_ms = 0.0;    ///< building the model
};

/// The same as an answer to a problem of so many columns, without multipliers.
[[nodiscard]] Solution solution_of(const CbcResult& result, int column_count);

/// Keeps its buffers between calls, nothing else. One object per thread.
class CbcSolver {
 public:
  /// Stops soon after the budget's deadline. Throws std::runtime_error if CBC gives up for another
  /// reason or answers with a choice that breaks a row.
  [[nodiscard]] CbcResult solve(const AssociationProblem& problem, const Budget& budget);

  /// The same for `columns` (ascending) alone, which are one or several connected components of
  /// the problem: only the rows that they use count.
  [[nodiscard]] CbcResult solve_part(const AssociationProblem& problem,
                                     std::span<const int> columns, const Budget& budget);

 private:
  void gather(const AssociationProblem& problem, std::span<const int> columns);
  void load(ClpSimplex& root) const;

  // The part in COIN's form; its rows are numbered in the order of their first use.
  std::vector<int> begins_;
  std::vector<int> rows_;
  std::vector<double> costs_;
  std::vector<double> row_lower_;
  std::vector<double> ones_;
  std::vector<int> number_of_row_;
};

}  // namespace mda
