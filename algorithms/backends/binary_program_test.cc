#include "algorithms/backends/binary_program.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "algorithms/testing/draw.h"

namespace mda {
namespace {

using testing::Draw;

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTolerance = 1e-7;

/// Up to 10 variables with costs of both signs; rows of -1 and 1 that are bounded from above, from
/// below or fixed.
BinaryProgram random_program(std::uint64_t seed) {
  Draw draw(seed);
  BinaryProgram program;
  const int rows = 1 + draw.below(5);
  for (int r = 0; r < rows; ++r) {
    const double bound = draw.below(3) - 1;
    const int kind = draw.below(4);
    program.add_row(kind == 0 ? -kInfinity : bound, kind >= 2 ? kInfinity : bound);
  }
  const int variables = 1 + draw.below(10);
  for (int j = 0; j < variables; ++j) {
    std::vector<BinaryProgram::Entry> entries;
    for (int r = 0; r < rows; ++r) {
      if (draw.chance(0.5)) entries.push_back({r, draw.chance(0.4) ? -1.0 : 1.0});
    }
    program.add_variable(10.0 * draw.unit() - 6.0, entries);
  }
  return program;
}

double cost_of(const BinaryProgram& program, const std::vector<double>& x) {
  double cost = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j) cost += program.costs[j] * x[j];
  return cost;
}

bool is_feasible(const BinaryProgram& program, const std::vector<double>& x) {
  std::vector<double> sum(program.row_lower.size(), 0.0);
  for (std::size_t j = 0; j < x.size(); ++j) {
    for (int e = program.begins[j]; e < program.begins[j + 1]; ++e) {
      sum[index(program.rows[index(e)])] += program.coefficients[index(e)] * x[j];
    }
  }
  for (std::size_t r = 0; r < sum.size(); ++r) {
    if (sum[r] < program.row_lower[r] - kTolerance) return false;
    if (sum[r] > program.row_upper[r] + kTolerance) return false;
  }
  return true;
}

std::optional<double> optimum(const BinaryProgram& program) {
  std::optional<double> best;
  std::vector<double> x(program.costs.size());
  for (unsigned choice = 0; choice < 1U << x.size(); ++choice) {
    for (std::size_t j = 0; j < x.size(); ++j) x[j] = (choice >> j) & 1U;
    if (!is_feasible(program, x)) continue;
    const double cost = cost_of(program, x);
    if (!best.has_value() || cost < *best) best = cost;
  }
  return best;
}

TEST(BinaryProgram, OptimaAreThoseOfEnumeration) {
  int infeasible = 0;
  int branched = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    const BinaryProgram program = random_program(seed);
    const std::optional<double> best = optimum(program);
    const BinaryResult result = solve_program(program, Integrality::kBinary, Budget{});
    const BinaryResult relaxed = solve_program(program, Integrality::kRelaxed, Budget{});
    branched += result.lp_fractional > 0 ? 1 : 0;
    EXPECT_EQ(result.lp_fractional, relaxed.lp_fractional);
    if (!best.has_value()) {
      EXPECT_EQ(result.outcome, Outcome::kInfeasible);
      EXPECT_TRUE(result.x.empty());
      ++infeasible;
      continue;
    }
    ASSERT_EQ(result.outcome, Outcome::kOptimal);
    for (const double value : result.x) EXPECT_TRUE(value == 0.0 || value == 1.0);
    EXPECT_TRUE(is_feasible(program, result.x));
    EXPECT_NEAR(cost_of(program, result.x), *best, kTolerance);
    ASSERT_EQ(relaxed.outcome, Outcome::kOptimal);
    EXPECT_TRUE(is_feasible(program, relaxed.x));
    EXPECT_LE(cost_of(program, relaxed.x), *best + kTolerance);
  }
  EXPECT_GE(infeasible, 50);
  EXPECT_GE(branched, 30);
}

TEST(BinaryProgram, WithoutVariablesOnlyTheRowsCount) {
  BinaryProgram program;
  program.add_row(-kInfinity, 0.0);
  EXPECT_EQ(solve_program(program, Integrality::kBinary, Budget{}).outcome, Outcome::kOptimal);
  program.add_row(1.0, kInfinity);
  EXPECT_EQ(solve_program(program, Integrality::kBinary, Budget{}).outcome, Outcome::kInfeasible);
}

TEST(BinaryProgram, NothingAfterTheDeadline) {
  Budget budget;
  budget.deadline = Clock::now() - std::chrono::seconds(1);
  const BinaryResult result = solve_program(random_program(1), Integrality::kBinary, budget);
  EXPECT_EQ(result.outcome, Outcome::kDeadline);
  EXPECT_TRUE(result.x.empty());
}

}  // namespace
}  // namespace mda
