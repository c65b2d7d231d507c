#include "algorithms/multisensor/tuple_columns.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace mda {

TupleColumns::TupleColumns(const AssociationProblem& problem)
    : problem_(problem), columns_(static_cast<std::size_t>(problem.columns())) {
  std::iota(columns_.begin(), columns_.end(), 0);
  std::ranges::sort(columns_, [&](int a, int b) {
    return std::ranges::lexicographical_compare(problem.rows_of(a), problem.rows_of(b));
  });
}

int TupleColumns::find(const Tuple& tuple) const {
  std::vector<int> rows;
  std::ranges::copy_if(tuple.rows, std::back_inserter(rows), [](int row) { return row != kNoRow; });
  std::ranges::sort(rows);
  const auto found = std::ranges::lower_bound(
      columns_, rows,
      [](const auto& a, const auto& b) { return std::ranges::lexicographical_compare(a, b); },
      [&](int column) { return problem_.rows_of(column); });
  if (found == columns_.end()) return kNoColumn;
  return std::ranges::equal(problem_.rows_of(*found), rows) ? *found : kNoColumn;
}

}  // namespace mda
