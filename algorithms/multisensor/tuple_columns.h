// The column of a tuple of reports, if there is one.
#pragma once

#include <vector>

#include "algorithms/api/problem.h"

namespace mda {

/// Refers to the problem, which must stay.
class TupleColumns {
 public:
  /// O(columns log columns).
  explicit TupleColumns(const AssociationProblem& problem);

  /// The column that uses the tuple's rows and no others, or kNoColumn. O(log columns).
  [[nodiscard]] int find(const Tuple& tuple) const;

 private:
  const AssociationProblem& problem_;
  std::vector<int> columns_;  ///< in the lexicographic order of their rows
};

}  // namespace mda
