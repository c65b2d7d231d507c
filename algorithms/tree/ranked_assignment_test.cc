#include "algorithms/tree/ranked_assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "algorithms/testing/draw.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Sparse and dense, with rows that must take a column, whole and real costs.
SparseCosts random_costs(std::uint64_t seed) {
  Draw draw(seed);
  const int rows = 1 + draw.below(5);
  const double density = draw.chance(0.5) ? 0.4 : 0.9;
  const double must = draw.chance(0.5) ? 0.0 : 0.4;
  const bool whole = draw.chance(0.3);
  const auto cost = [&] { return whole ? draw.below(7) - 4.0 : 7.0 * draw.unit() - 4.0; };
  SparseCosts costs;
  costs.columns = 1 + draw.below(5);
  costs.row_begin.push_back(0);
  for (int i = 0; i < rows; ++i) {
    for (const int j : draw.permutation(costs.columns)) {
      if (!draw.chance(density)) continue;
      costs.column.push_back(j);
      costs.cost.push_back(cost());
    }
    costs.row_begin.push_back(static_cast<int>(costs.column.size()));
    costs.alone.push_back(draw.chance(must) ? kInfinity : cost());
  }
  return costs;
}

/// Of one row's choice; infinite if it is not allowed.
double cost_of(const SparseCosts& costs, int row, int column) {
  if (column == Assignment::kAlone) return costs.alone[index(row)];
  for (int e = costs.row_begin[index(row)]; e < costs.row_begin[index(row) + 1]; ++e) {
    if (costs.column[index(e)] == column) return costs.cost[index(e)];
  }
  return kInfinity;
}

/// Costs of all assignments of the rows from `row` on, added to `cost`.
void enumerate(const SparseCosts& costs, int row, double cost, std::set<int>& used,
               std::vector<double>& all) {
  if (row == costs.rows()) {
    all.push_back(cost);
    return;
  }
  for (int j = Assignment::kAlone; j < costs.columns; ++j) {
    const double more = cost_of(costs, row, j);
    if (!std::isfinite(more) || used.count(j) > 0) continue;
    if (j != Assignment::kAlone) used.insert(j);
    enumerate(costs, row + 1, cost + more, used, all);
    used.erase(j);
  }
}

TEST(RankedAssignmentsTest, AllComeOnceInOrder) {
  AssignmentSolver solver;
  int without = 0;
  int many = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const SparseCosts costs = random_costs(seed);
    std::vector<double> all;
    std::set<int> used;
    enumerate(costs, 0, 0.0, used, all);
    std::sort(all.begin(), all.end());
    RankedAssignments ranked(costs, solver);
    std::set<std::vector<int>> different;
    for (const double expected : all) {
      ASSERT_FALSE(ranked.empty());
      const double announced = ranked.next_cost();
      const RankedAssignment next = ranked.take();
      EXPECT_EQ(next.cost, announced);
      EXPECT_NEAR(next.cost, expected, 1e-9);
      double sum = 0.0;
      std::set<int> columns;
      for (int i = 0; i < costs.rows(); ++i) {
        const int column = next.column_of_row[index(i)];
        sum += cost_of(costs, i, column);
        EXPECT_TRUE(column == Assignment::kAlone || columns.insert(column).second);
      }
      EXPECT_NEAR(sum, next.cost, 1e-9);
      EXPECT_TRUE(different.insert(next.column_of_row).second);
    }
    EXPECT_TRUE(ranked.empty());
    without += all.empty() ? 1 : 0;
    many += all.size() > 50 ? 1 : 0;
  }
  EXPECT_GE(without, 10);
  EXPECT_GE(many, 50);
}

TEST(RankedAssignmentsTest, NoRowsHaveOneAssignment) {
  AssignmentSolver solver;
  SparseCosts costs;
  costs.columns = 2;
  costs.row_begin = {0};
  RankedAssignments ranked(costs, solver);
  ASSERT_FALSE(ranked.empty());
  EXPECT_EQ(ranked.take().cost, 0.0);
  EXPECT_TRUE(ranked.empty());
}

}  // namespace
}  // namespace mda::testing
