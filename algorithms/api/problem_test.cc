#include "algorithms/api/problem.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/testing/draw.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/tiny_problems.h"

namespace mda::testing {
namespace {

/// Rows 0 and 1 in dimension 1, row 2 in dimension 2; one good column.
ProblemBuilder small_builder() {
  ProblemBuilder builder;
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_row(2, RowUse::kExactlyOnce);
  builder.add_column(-1.0, std::vector{0, 2});
  return builder;
}

/// What build() says when it refuses.
std::string refusal(const ProblemBuilder& builder) {
  try {
    (void)builder.build();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string refusal_of_column(double cost, const std::vector<int>& rows) {
  ProblemBuilder builder = small_builder();
  builder.add_column(cost, rows);
  return refusal(builder);
}

TEST(ProblemBuilderTest, RefusesABadColumnByItsNumber) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::string> refusals = {
      refusal_of_column(infinity, {0}), refusal_of_column(nan, {0}),
      refusal_of_column(-1.0, {}),      refusal_of_column(-1.0, {3}),
      refusal_of_column(-1.0, {-1}),    refusal_of_column(-1.0, {0, 1}),
      refusal_of_column(-1.0, {0, 0})};
  for (const std::string& text : refusals) {
    EXPECT_NE(text.find("column 1:"), std::string::npos) << text;
  }
  EXPECT_NE(refusal_of_column(-1.0, {3}).find("row 3"), std::string::npos);
  EXPECT_NE(refusal_of_column(-1.0, {0, 1}).find("dimension 1"), std::string::npos);
}

TEST(ProblemBuilderTest, RefusesARowOfNegativeDimensionByItsNumber) {
  ProblemBuilder builder = small_builder();
  builder.add_row(-1, RowUse::kAtMostOnce);
  EXPECT_NE(refusal(builder).find("row 3:"), std::string::npos) << refusal(builder);
}

TEST(ProblemBuilderTest, IsLeftAsItWas) {
  const ProblemBuilder builder = small_builder();
  EXPECT_EQ(builder.build().fingerprint(), builder.build().fingerprint());
}

TEST(ProblemBuilderTest, ClearForgetsEverything) {
  ProblemBuilder builder = small_builder();
  builder.set_dimensions(7);
  builder.clear();
  EXPECT_EQ(builder.build().fingerprint(), AssociationProblem().fingerprint());
  EXPECT_EQ(builder.build().shape().dimensions, 0);
}

AssociationProblem problem_of(std::uint64_t seed) {
  return random_problem(random_shape(seed, 40), seed);
}

RC_GTEST_PROP(ProblemTest, KeepsWhatTheBuilderGot, (std::uint64_t seed)) {
  Draw draw(seed);
  ProblemBuilder builder;
  std::vector<std::vector<int>> rows_of;
  for (int d = 0; d < 5; ++d) builder.add_row(d, RowUse::kAtMostOnce);
  for (int j = 0; j < 10; ++j) {
    std::vector<int> rows = draw.permutation(5);
    rows.resize(static_cast<std::size_t>(1 + draw.below(5)));
    builder.add_column(j, rows);
    std::sort(rows.begin(), rows.end());
    rows_of.push_back(rows);
  }
  const AssociationProblem problem = builder.build();
  for (int j = 0; j < 10; ++j) {
    const auto rows = problem.rows_of(j);
    RC_ASSERT(problem.cost(j) == j);
    RC_ASSERT(std::vector(rows.begin(), rows.end()) == rows_of[static_cast<std::size_t>(j)]);
  }
}

/// Copies a problem, letting `edit` change what is about to be added.
struct Edit {
  std::function<void(int row, int& dimension, RowUse& use)> row = [](int, int&, RowUse&) {};
  std::function<void(int column, double& cost)> column = [](int, double&) {};
};

std::string fingerprint_after(const AssociationProblem& problem, const Edit& edit) {
  ProblemBuilder builder;
  for (int r = 0; r < problem.rows(); ++r) {
    int dimension = problem.dimension(r);
    RowUse use = problem.use(r);
    edit.row(r, dimension, use);
    builder.add_row(dimension, use);
  }
  for (int j = 0; j < problem.columns(); ++j) {
    double cost = problem.cost(j);
    edit.column(j, cost);
    builder.add_column(cost, problem.rows_of(j));
  }
  return builder.build().fingerprint();
}

RC_GTEST_PROP(FingerprintTest, SeesEveryChangeButTheLastBits, (std::uint64_t seed)) {
  const AssociationProblem problem = problem_of(seed);
  RC_PRE(problem.columns() > 0);
  Draw draw(seed);
  const int column = draw.below(problem.columns());
  const int row = draw.below(problem.rows());
  const std::string before = problem.fingerprint();
  RC_ASSERT(before.size() == 16U);
  RC_ASSERT(before.find_first_not_of("0123456789abcdef") == std::string::npos);
  RC_ASSERT(fingerprint_after(problem, {}) == before);

  Edit edit;
  edit.column = [&](int j, double& cost) { cost += j == column ? 1e-3 : 0.0; };
  RC_ASSERT(fingerprint_after(problem, edit) != before);
  edit = {};
  edit.row = [&](int r, int&, RowUse& use) {
    if (r != row) return;
    use = use == RowUse::kAtMostOnce ? RowUse::kExactlyOnce : RowUse::kAtMostOnce;
  };
  RC_ASSERT(fingerprint_after(problem, edit) != before);
  edit = {};
  edit.row = [&](int r, int& dimension, RowUse&) { dimension += r == row ? 10 : 0; };
  RC_ASSERT(fingerprint_after(problem, edit) != before);
}

TEST(FingerprintTest, IsBlindToTheLastBitsOfACost) {
  const std::vector<int> rows = {0, 2};
  std::map<double, std::string> fingerprints;
  for (const double cost : {-1.0, -1.0 + 1e-9, -1.0 + 2e-6}) {
    ProblemBuilder builder = small_builder();
    builder.add_column(cost, rows);
    fingerprints[cost] = builder.build().fingerprint();
  }
  EXPECT_EQ(fingerprints[-1.0], fingerprints[-1.0 + 1e-9]);
  EXPECT_NE(fingerprints[-1.0], fingerprints[-1.0 + 2e-6]);
}

TEST(FingerprintTest, TellsTheTinyProblemsApart) {
  std::map<std::string, std::string> name_of;
  for (const TinyProblem& tiny : tiny_problems()) {
    const auto [other, is_new] = name_of.emplace(tiny.problem.fingerprint(), tiny.name);
    EXPECT_TRUE(is_new) << tiny.name << " and " << other->second;
  }
}

/// Numbers the components by walking over shared rows.
std::vector<int> components_by_walking(const AssociationProblem& problem) {
  const auto shares_a_row = [&](int a, int b) {
    const auto rows = problem.rows_of(b);
    return std::any_of(problem.rows_of(a).begin(), problem.rows_of(a).end(),
                       [&](int r) { return std::find(rows.begin(), rows.end(), r) != rows.end(); });
  };
  std::vector<int> component(static_cast<std::size_t>(problem.columns()), -1);
  int next = 0;
  for (int start = 0; start < problem.columns(); ++start) {
    if (component[static_cast<std::size_t>(start)] >= 0) continue;
    std::vector<int> to_visit = {start};
    while (!to_visit.empty()) {
      const int j = to_visit.back();
      to_visit.pop_back();
      if (component[static_cast<std::size_t>(j)] >= 0) continue;
      component[static_cast<std::size_t>(j)] = next;
      for (int k = 0; k < problem.columns(); ++k) {
        if (shares_a_row(j, k)) to_visit.push_back(k);
      }
    }
    ++next;
  }
  return component;
}

RC_GTEST_PROP(ShapeTest, CountsTheComponents, (std::uint64_t seed)) {
  const AssociationProblem problem = problem_of(seed);
  const auto numbers = problem.component_of_column();
  RC_ASSERT(std::vector(numbers.begin(), numbers.end()) == components_by_walking(problem));
  std::map<int, int> size;
  for (const int c : numbers) ++size[c];
  int largest = 0;
  for (const auto& [c, columns] : size) largest = std::max(largest, columns);
  RC_ASSERT(problem.shape().components == static_cast<int>(size.size()));
  RC_ASSERT(problem.shape().largest_component_columns == largest);
}

RC_GTEST_PROP(ShapeTest, PromisesOnlyWhatIsFeasible, (std::uint64_t seed)) {
  const AssociationProblem problem = problem_of(seed);
  if (problem.shape().always_feasible) RC_ASSERT(optimum(problem).has_value());
  if (!problem.shape().has_exactly_once_rows) RC_ASSERT(problem.shape().always_feasible);
}

TEST(ShapeTest, CountsTheDimensionsUnlessTold) {
  ProblemBuilder builder = small_builder();
  EXPECT_EQ(builder.build().shape().dimensions, 2);
  builder.set_dimensions(4);
  EXPECT_EQ(builder.build().shape().dimensions, 4);
}

TEST(CoastingCostsTest, AreThoseOfTheTracksAlone) {
  EXPECT_EQ(coasting_costs(tiny_problem("coasting track").problem), (std::vector{-1.0, 0.0, 0.0}));
  EXPECT_EQ(coasting_costs(tiny_problem("must go on").problem), (std::vector{0.0, 0.0}));
  EXPECT_EQ(coasting_costs(tiny_problem("greedy trap").problem), (std::vector{0.0, 0.0}));
}

/// Two by two by two with some columns replaced or left out.
bool is_axial(RowUse use, const std::vector<std::vector<int>>& columns) {
  ProblemBuilder builder;
  for (const int dimension : {1, 3, 1, 2, 2, 3}) builder.add_row(dimension, use);
  for (const auto& rows : columns) builder.add_column(1.0, rows);
  return builder.build().shape().is_axial;
}

TEST(ProblemTest, AxialMeansEveryCombinationOnce) {
  std::vector<std::vector<int>> all;
  for (const int a : {0, 2}) {
    for (const int b : {3, 4}) {
      for (const int c : {1, 5}) all.push_back({a, b, c});
    }
  }
  EXPECT_TRUE(is_axial(RowUse::kExactlyOnce, all));
  EXPECT_FALSE(is_axial(RowUse::kAtMostOnce, all));
  EXPECT_FALSE(is_axial(RowUse::kExactlyOnce, {}));
  for (std::size_t j = 0; j < all.size(); ++j) {
    auto changed = all;
    changed[j] = all[(j + 1) % all.size()];
    EXPECT_FALSE(is_axial(RowUse::kExactlyOnce, changed)) << "a combination is there twice";
    changed[j].pop_back();
    EXPECT_FALSE(is_axial(RowUse::kExactlyOnce, changed)) << "a column of two rows";
    changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(j));
    EXPECT_FALSE(is_axial(RowUse::kExactlyOnce, changed)) << "a combination is not there";
  }
  EXPECT_TRUE(tiny_problem("axial").problem.shape().is_axial);
  EXPECT_FALSE(tiny_problem("triangle that must").problem.shape().is_axial);
}

}  // namespace
}  // namespace mda::testing
