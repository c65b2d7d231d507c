#include "algorithms/backends/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "algorithms/backends/lemon_flow.h"
#include "algorithms/testing/draw.h"

namespace mda {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

struct Shape2 {
  int rows = 0;
  int columns = 0;
  double density = 0.5;
  double must_take = 0.3;
  bool whole_costs = false;
};

double random_cost(const Shape2& shape, testing::Draw& draw) {
  const double cost = 20.0 * draw.unit() - 10.0;
  return shape.whole_costs ? std::floor(cost / 4.0) : cost;
}

SparseCosts random_costs(const Shape2& shape, testing::Draw& draw) {
  SparseCosts costs;
  costs.columns = shape.columns;
  costs.row_begin.push_back(0);
  for (int i = 0; i < shape.rows; ++i) {
    for (int j = 0; j < shape.columns; ++j) {
      if (!draw.chance(shape.density)) continue;
      costs.column.push_back(j);
      costs.cost.push_back(random_cost(shape, draw));
    }
    costs.row_begin.push_back(static_cast<int>(costs.column.size()));
    costs.alone.push_back(draw.chance(shape.must_take) ? kInfinity : random_cost(shape, draw));
  }
  return costs;
}

Shape2 small_shape(testing::Draw& draw) {
  return {draw.below(7), draw.below(7), draw.unit(), draw.unit(), draw.chance(0.5)};
}

/// Every assignment of the rows from `row` onwards to columns that are not in `used`.
double brute_force(const SparseCosts& costs, int row, unsigned used) {
  if (row == costs.rows()) return 0.0;
  double best = costs.alone[index(row)];
  if (best < kInfinity) best += brute_force(costs, row + 1, used);
  for (int e = costs.row_begin[index(row)]; e < costs.row_begin[index(row) + 1]; ++e) {
    const unsigned bit = 1U << static_cast<unsigned>(costs.column[index(e)]);
    if ((used & bit) != 0) continue;
    best = std::min(best, costs.cost[index(e)] + brute_force(costs, row + 1, used | bit));
  }
  return best;
}

/// What a pair costs, listed perhaps more than once.
double pair_cost(const SparseCosts& costs, int row, int column) {
  double least = kInfinity;
  for (int e = costs.row_begin[index(row)]; e < costs.row_begin[index(row) + 1]; ++e) {
    if (costs.column[index(e)] == column) least = std::min(least, costs.cost[index(e)]);
  }
  return least;
}

void expect_valid(const SparseCosts& costs, const Assignment& assignment) {
  std::vector<char> used(index(costs.columns), 0);
  double cost = 0.0;
  for (int i = 0; i < costs.rows(); ++i) {
    const int column = assignment.column_of_row[index(i)];
    if (column == Assignment::kAlone) {
      cost += costs.alone[index(i)];
      continue;
    }
    EXPECT_EQ(used[index(column)]++, 0);
    cost += pair_cost(costs, i, column);
  }
  ASSERT_TRUE(std::isfinite(cost));
  EXPECT_NEAR(assignment.cost, cost, 1e-9);
}

void expect_dual_feasible(const SparseCosts& costs, const Assignment& assignment) {
  for (const double price : assignment.column_price) EXPECT_GE(price, 0.0);
  for (int i = 0; i < costs.rows(); ++i) {
    EXPECT_LE(assignment.row_price[index(i)], costs.alone[index(i)]);
    for (int e = costs.row_begin[index(i)]; e < costs.row_begin[index(i) + 1]; ++e) {
      EXPECT_LE(assignment.row_price[index(i)],
                costs.cost[index(e)] + assignment.column_price[index(costs.column[index(e)])]);
    }
  }
}

double dual_value(const Assignment& assignment) {
  double value = 0.0;
  for (const double price : assignment.row_price) value += price;
  for (const double price : assignment.column_price) value -= price;
  return value;
}

TEST(Assignment, IsTheBestOfAllAndItsPricesProveIt) {
  AssignmentSolver solver;
  int infeasible = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(seed);
    testing::Draw draw(seed);
    const SparseCosts costs = random_costs(small_shape(draw), draw);
    const double best = brute_force(costs, 0, 0);
    const Assignment& assignment = solver.solve(costs);
    ASSERT_EQ(assignment.feasible, best < kInfinity);
    expect_dual_feasible(costs, assignment);
    if (!assignment.feasible) {
      ++infeasible;
      EXPECT_EQ(assignment.cost, kInfinity);
      continue;
    }
    expect_valid(costs, assignment);
    EXPECT_NEAR(assignment.cost, best, 1e-9);
    EXPECT_NEAR(dual_value(assignment), best, 1e-9);
  }
  EXPECT_GE(infeasible, 300);
  EXPECT_LE(infeasible, 2700);
}

/// Rows supply a unit each; it goes through a column of capacity 1 or past all of them.
double by_network_simplex(const SparseCosts& costs, double units_per_nat) {
  const auto units = [&](double cost) {
    return static_cast<std::int64_t>(std::llround(cost * units_per_nat));
  };
  const int sink = costs.rows() + costs.columns;
  FlowGraph graph;
  graph.nodes = sink + 1;
  graph.supply.assign(index(graph.nodes), 0);
  for (int i = 0; i < costs.rows(); ++i) {
    graph.supply[index(i)] = 1;
    for (int e = costs.row_begin[index(i)]; e < costs.row_begin[index(i) + 1]; ++e) {
      graph.arcs.push_back(
          {i, costs.rows() + costs.column[index(e)], 1, units(costs.cost[index(e)])});
    }
    if (costs.alone[index(i)] < kInfinity) {
      graph.arcs.push_back({i, sink, 1, units(costs.alone[index(i)])});
    }
  }
  for (int j = 0; j < costs.columns; ++j) graph.arcs.push_back({costs.rows() + j, sink, 1, 0});
  graph.supply[index(sink)] = -costs.rows();
  const std::vector<std::int64_t> flow = network_simplex_flow(graph).flow;
  if (flow.empty()) return kInfinity;
  double cost = 0.0;
  for (std::size_t a = 0; a < flow.size(); ++a) {
    cost += static_cast<double>(flow[a] * graph.arcs[a].cost) / units_per_nat;
  }
  return cost;
}

TEST(Assignment, AgreesWithNetworkSimplexOnLargerOnes) {
  AssignmentSolver solver;
  int feasible = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    testing::Draw draw(seed);
    const int rows = 1 + draw.below(80);
    const int columns = 1 + draw.below(120);
    const SparseCosts costs =
        random_costs({rows, columns, 0.2 * draw.unit(), 0.2 * draw.unit(), draw.chance(0.3)}, draw);
    const double best = by_network_simplex(costs, 1 << 20);
    const Assignment& assignment = solver.solve(costs);
    ASSERT_EQ(assignment.feasible, best < kInfinity);
    if (!assignment.feasible) continue;
    ++feasible;
    expect_valid(costs, assignment);
    expect_dual_feasible(costs, assignment);
    EXPECT_NEAR(dual_value(assignment), assignment.cost, 1e-9);
    // Rounding to whole units moves each row's cost by half a unit at most, in both solutions.
    EXPECT_NEAR(assignment.cost, best, rows / static_cast<double>(1 << 20));
  }
  EXPECT_GE(feasible, 15);
}

/// The same costs with rows, columns and entries in another order.
SparseCosts reordered(const SparseCosts& costs, testing::Draw& draw) {
  const std::vector<int> rows = draw.permutation(costs.rows());
  const std::vector<int> columns = draw.permutation(costs.columns);
  SparseCosts other;
  other.columns = costs.columns;
  other.row_begin.push_back(0);
  for (const int i : rows) {
    const int first = costs.row_begin[index(i)];
    for (const int e : draw.permutation(costs.row_begin[index(i) + 1] - first)) {
      other.column.push_back(columns[index(costs.column[index(first + e)])]);
      other.cost.push_back(costs.cost[index(first + e)]);
    }
    other.row_begin.push_back(static_cast<int>(other.column.size()));
    other.alone.push_back(costs.alone[index(i)]);
  }
  return other;
}

TEST(Assignment, OrderDoesNotMatter) {
  AssignmentSolver solver;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    testing::Draw draw(seed);
    const SparseCosts costs = random_costs(small_shape(draw), draw);
    const SparseCosts other = reordered(costs, draw);
    const Assignment first = solver.solve(costs);
    const Assignment second = solver.solve(other);
    ASSERT_EQ(first.feasible, second.feasible);
    if (!first.feasible) continue;
    EXPECT_NEAR(first.cost, second.cost, 1e-9);
  }
}

TEST(Assignment, OfTwoEntriesOfAPairTheCheaperCounts) {
  const SparseCosts costs{1, {0, 2}, {0, 0}, {-1.0, -2.0}, {0.0}};
  AssignmentSolver solver;
  EXPECT_EQ(solver.solve(costs).cost, -2.0);
}

TEST(Assignment, WithoutRowsCostsNothing) {
  AssignmentSolver solver;
  const Assignment& assignment = solver.solve({3, {0}, {}, {}, {}});
  EXPECT_TRUE(assignment.feasible);
  EXPECT_EQ(assignment.cost, 0.0);
  EXPECT_EQ(assignment.column_price, (std::vector<double>(3, 0.0)));
}

TEST(Assignment, KeepsNothingBetweenCalls) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    testing::Draw draw(seed);
    const SparseCosts first = random_costs(small_shape(draw), draw);
    const SparseCosts second = random_costs(small_shape(draw), draw);
    AssignmentSolver used;
    (void)used.solve(first);
    AssignmentSolver fresh;
    const Assignment& a = used.solve(second);
    const Assignment& b = fresh.solve(second);
    EXPECT_EQ(a.column_of_row, b.column_of_row);
    EXPECT_EQ(a.row_price, b.row_price);
    EXPECT_EQ(a.column_price, b.column_price);
  }
}

}  // namespace
}  // namespace mda
