#include "algorithms/testing/marginal_laws.h"

#include <gtest/gtest.h>

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kTolerance = 1e-9;

}  // namespace

bool is_track(const AssociationProblem& problem, int row) {
  for (int r = 0; r < problem.rows(); ++r) {
    if (problem.dimension(r) < problem.dimension(row)) return false;
  }
  return true;
}

void expect_distributions(const AssociationProblem& problem, const Solution& solution,
                          bool consistent) {
  std::vector<double> used(index(problem.rows()), 0.0);
  for (int j = 0; j < problem.columns(); ++j) {
    for (const int r : problem.rows_of(j)) used[index(r)] += solution.x[index(j)];
  }
  for (int r = 0; r < problem.rows(); ++r) {
    const bool track = is_track(problem, r);
    if (track || consistent) {
      EXPECT_LE(used[index(r)], 1.0 + kTolerance) << "row " << r;
    }
    if (track && problem.use(r) == RowUse::kExactlyOnce) {
      EXPECT_GE(used[index(r)], 1.0 - kTolerance) << "row " << r;
    }
  }
}

void expect_close_marginals(const Solution& a, const Solution& b,
                            const std::vector<int>& column_to) {
  EXPECT_EQ(a.status, b.status);
  ASSERT_EQ(a.x.size(), b.x.size());
  for (std::size_t j = 0; j < a.x.size(); ++j) {
    EXPECT_NEAR(a.x[j], b.x[index(column_to[j])], kTolerance) << "column " << j;
  }
}

}  // namespace mda::testing
