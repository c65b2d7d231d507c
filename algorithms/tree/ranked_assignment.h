// The assignments of a two-dimensional problem one after the other, the cheapest first.
#pragma once

#include <optional>
#include <queue>
#include <vector>

#include "algorithms/backends/assignment.h"

namespace mda {

struct RankedAssignment {
  double cost = 0.0;
  std::vector<int> column_of_row;  ///< or Assignment::kAlone
};

/// Every assignment of the rows comes once, in order of cost. Of a pair that is listed twice the
/// cheaper entry counts.
///
/// The assignments left after the best one are split by the first row that does something else. A
/// part fixes the rows before it and solves again only what hangs together with it. So take() costs
/// at most `rows` assignment problems, mostly small ones, and the j-th assignment is found after
/// j * rows of them.
/// Source: Murty 1968, An algorithm for ranking all the assignments in order of increasing cost,
/// Operations Research 16; as used for tracking by Cox and Hingorani 1996, An efficient
/// implementation of Reid's multiple hypothesis tracking algorithm, IEEE PAMI 18, section 3.
class RankedAssignments {
 public:
  /// `solver` is used by next calls too and must live as long; several objects may share it.
  RankedAssignments(SparseCosts costs, AssignmentSolver& solver);

  /// There is no further assignment.
  [[nodiscard]] bool empty() const { return parts_.empty(); }

  /// Cost of the next one. Not if empty().
  [[nodiscard]] double next_cost() const { return parts_.top().best.cost; }

  /// Returns the next one and looks for its successor. Not if empty().
  RankedAssignment take();

 private:
  /// All assignments that agree with `best` in the first `fixed` rows, and in which the row after
  /// them does nothing of what is `forbidden`.
  struct Part {
    RankedAssignment best;
    int fixed = 0;
    std::vector<int> forbidden;  ///< columns, or Assignment::kAlone
  };
  struct ComesLater {
    bool operator()(const Part& a, const Part& b) const;
  };

  void list_rows_of_columns();
  void split(const Part& part);
  [[nodiscard]] std::optional<RankedAssignment> best_of(const Part& part);
  void reach(int first_row);
  void gather(const Part& part);
  [[nodiscard]] double cost_of(const std::vector<int>& column_of_row) const;

  SparseCosts costs_;
  AssignmentSolver& solver_;
  std::vector<int> rows_begin_;  ///< rows_[rows_begin_[j]] onwards are the rows that want column j
  std::vector<int> rows_;
  std::priority_queue<Part, std::vector<Part>, ComesLater> parts_;

  // The part's problem: what hangs together with its first row that is not fixed.
  std::vector<char> taken_;  ///< per column: by a fixed row
  std::vector<char> row_reached_;
  std::vector<int> reached_rows_;    ///< of the part's problem, by their number there
  std::vector<int> column_in_part_;  ///< number in the part's problem, or kNotReached
  std::vector<int> reached_columns_;
  SparseCosts open_;
};

}  // namespace mda
