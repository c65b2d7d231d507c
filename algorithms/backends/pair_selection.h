// The association problem with two dimensions: its optimum and the multipliers that prove it.
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/api/problem.h"
#include "algorithms/backends/assignment.h"

namespace mda {

/// A column that uses a row of the first side, of the second, or both.
struct PairOption {
  static constexpr int kNone = -1;

  int first = kNone;
  int second = kNone;
  double cost = 0.0;
};

/// Choose options of least total cost so that every row is used as often as it may be.
struct PairProblem {
  std::vector<RowUse> first;
  std::vector<RowUse> second;
  std::vector<PairOption> options;
};

struct PairSelection {
  bool feasible = false;
  std::vector<int> chosen;  ///< options, ascending; without those that gain nothing
  /// Row multipliers u, not negative on at-most-once rows, whose bound L(u) is the cost of the
  /// choice (algorithms/README.md); they prove nothing if there is no feasible choice.
  std::vector<double> first_multiplier;
  std::vector<double> second_multiplier;
};

/// Solves PairProblems as one assignment of the first side to the second, or, where some row of the
/// second side must be in a pair, as one twice as large. Any cost may be negative. O(assignment).
/// Keeps buffers between calls, no information; one object per thread.
class PairSelector {
 public:
  /// The result lives until the next call.
  const PairSelection& solve(const PairProblem& problem);

 private:
  /// What it costs to leave a row out of all pairs, and the option that does it, if any.
  struct Rest {
    double cost = 0.0;
    int option = PairOption::kNone;
  };

  void find_rests(const PairProblem& problem);
  void group_pairs(const PairProblem& problem);
  void fill_plain(const PairProblem& problem);
  void fill_twofold(const PairProblem& problem);
  void add_entry(int column, double cost);
  void choose(const PairProblem& problem, const Assignment& assignment);
  [[nodiscard]] int pair_option(const PairProblem& problem, int first, int second) const;

  AssignmentSolver solver_;
  SparseCosts costs_;
  PairSelection result_;
  std::vector<Rest> first_rest_;
  std::vector<Rest> second_rest_;
  std::vector<int> pair_begin_;  ///< per row of the first side: into pairs_
  std::vector<int> pairs_;       ///< options worth a look
  std::vector<char> second_in_pair_;
};

}  // namespace mda
