#include "scenarios/testing/choices.h"

#include <algorithm>
#include <numeric>

namespace mda::testing {

std::vector<int> those_that_fit(const AssociationProblem& problem, std::span<const int> order) {
  std::vector<bool> used(static_cast<std::size_t>(problem.rows()), false);
  std::vector<int> taken;
  for (const int column : order) {
    const auto rows = problem.rows_of(column);
    const auto is_used = [&](int row) { return used[static_cast<std::size_t>(row)]; };
    if (std::any_of(rows.begin(), rows.end(), is_used)) continue;
    for (const int row : rows) used[static_cast<std::size_t>(row)] = true;
    taken.push_back(column);
  }
  return taken;
}

std::vector<int> cheapest_that_fit(const AssociationProblem& problem) {
  std::vector<int> order(static_cast<std::size_t>(problem.columns()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return problem.cost(a) < problem.cost(b); });
  return those_that_fit(problem, order);
}

std::vector<int> leaves_of(const WindowInstance& window, std::span<const int> columns) {
  std::vector<int> leaves;
  for (const int column : columns) {
    const int leaf = window.leaf_of_column[static_cast<std::size_t>(column)];
    if (leaf >= 0) leaves.push_back(leaf);
  }
  return leaves;
}

}  // namespace mda::testing
