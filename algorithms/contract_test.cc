// Every entry of the catalogue against the laws of its traits.
#include "algorithms/testing/contract.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/entry_name.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/tiny_problems.h"

namespace mda::testing {
namespace {

struct Case {
  std::uint64_t seed;
  RandomShape shape;
  AssociationProblem problem;
};

/// Case number `seed`; brute force takes all of them.
Case random_case(std::uint64_t seed) {
  constexpr int kMostColumns = 24;
  const RandomShape shape = random_shape(seed, kMostColumns);
  return {seed, shape, random_problem(shape, seed)};
}

/// Odd cycles side by side: solving takes the longer the more there are, yet the optimum is known.
struct OddCycles {
  AssociationProblem problem;
  double optimum = 0.0;

  OddCycles(int count, RowUse use, std::uint64_t seed) {
    constexpr int kLength = 5;
    std::vector<AssociationProblem> cycles;
    for (int i = 0; i < count; ++i) {
      cycles.push_back(odd_cycle(kLength, use, 100 * seed + static_cast<std::uint64_t>(i)));
      optimum += *testing::optimum(cycles.back());
    }
    problem = side_by_side(cycles);
  }
};

/// Few rows, so that the optimum is known, but many columns.
AssociationProblem crowded_problem(std::uint64_t seed) {
  RandomShape shape;
  shape.dimensions = 4;
  shape.rows_per_dimension = 4;
  shape.columns = 300;
  shape.tracks = false;
  shape.presence = 0.5;
  shape.neighbourhood = 4;
  shape.positive_share = 0.0;
  return random_problem(shape, seed);
}

class ContractTest : public ::testing::TestWithParam<CatalogEntry> {
 protected:
  /// Laws that compare two answers hold for heuristics only where no two choices tie.
  [[nodiscard]] static bool comparable(const Case& c) {
    const Traits traits = GetParam().make()->traits();
    return traits.exact || !c.shape.integer_costs;
  }
};

TEST_P(ContractTest, TinyProblems) {
  for (const TinyProblem& tiny : tiny_problems()) {
    SCOPED_TRACE(tiny.name);
    expect_lawful_answer(GetParam().make, tiny.problem, tiny.optimum);
  }
}

TEST_P(ContractTest, RandomProblems) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = random_case(seed);
    expect_lawful_answer(GetParam().make, c.problem, optimum(c.problem));
  }
}

TEST_P(ContractTest, CrowdedProblems) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = crowded_problem(seed);
    expect_lawful_answer(GetParam().make, problem, optimum(problem));
  }
}

TEST_P(ContractTest, OddCyclesSideBySide) {
  for (const RowUse use : {RowUse::kAtMostOnce, RowUse::kExactlyOnce}) {
    for (const int count : {1, 2, 5}) {
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE(seed);
        const OddCycles cycles(count, use, seed);
        expect_lawful_answer(GetParam().make, cycles.problem, cycles.optimum);
      }
    }
  }
}

TEST_P(ContractTest, OrderDoesNotMatter) {
  for (std::uint64_t seed = 2001; seed <= 2200; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = random_case(seed);
    if (!comparable(c)) continue;
    expect_order_does_not_matter(GetParam().make, c.problem, reorder(c.problem, seed));
  }
}

TEST_P(ContractTest, MarginalsFollowTheirColumns) {
  for (std::uint64_t seed = 2001; seed <= 2200; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = random_case(seed);
    std::vector<int> column_to;
    const AssociationProblem other = reorder(c.problem, seed, &column_to);
    expect_marginals_follow(GetParam().make, c.problem, other, column_to);
  }
}

TEST_P(ContractTest, Scaling) {
  for (std::uint64_t seed = 2201; seed <= 2400; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = random_case(seed);
    if (comparable(c)) expect_scaling(GetParam().make, c.problem, seed % 2 == 0 ? 64.0 : 0.0625);
  }
}

TEST_P(ContractTest, ShiftOfAnExactlyOnceRow) {
  for (std::uint64_t seed = 2401; seed <= 2600; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = random_case(seed);
    for (int r = 0; r < c.problem.rows(); ++r) {
      if (c.problem.use(r) != RowUse::kExactlyOnce) continue;
      expect_shift(GetParam().make, c.problem, r, seed % 2 == 0 ? 3.5 : -3.5);
      break;
    }
  }
}

TEST_P(ContractTest, NoMemoryBetweenCalls) {
  for (std::uint64_t seed = 2601; seed <= 2700; ++seed) {
    SCOPED_TRACE(seed);
    expect_no_memory(GetParam().make, random_case(seed).problem, random_case(seed + 100).problem);
  }
  expect_no_memory(GetParam().make, crowded_problem(1), random_case(1).problem);
}

TEST_P(ContractTest, ThreadsDoNotDisturbEachOther) {
  std::vector<AssociationProblem> problems;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) problems.push_back(random_case(seed).problem);
  expect_threads_apart(GetParam().make, problems);
}

TEST_P(ContractTest, DeadlineInThePast) {
  for (std::uint64_t seed = 2801; seed <= 2900; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = random_case(seed);
    expect_honest_deadline(GetParam().make, c.problem, optimum(c.problem), -1);
  }
}

TEST_P(ContractTest, DeadlineOnTheWay) {
  for (const RowUse use : {RowUse::kAtMostOnce, RowUse::kExactlyOnce}) {
    for (const int count : {2, 5, 40}) {
      const OddCycles cycles(count, use, 1);
      for (const int microseconds : {20, 100, 300, 600, 1000, 2000, 4000, 8000, 16000}) {
        SCOPED_TRACE(microseconds);
        expect_honest_deadline(GetParam().make, cycles.problem, cycles.optimum, microseconds);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalog, ContractTest,
                         ::testing::ValuesIn(catalog().begin(), catalog().end()), entry_name);

TEST(CatalogTest, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const CatalogEntry& entry : catalog()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    ASSERT_NE(find_algorithm(entry.name), nullptr);
    EXPECT_EQ(find_algorithm(entry.name)->make, entry.make);
    EXPECT_FALSE(entry.family.empty() || entry.summary.empty() || entry.source.empty());
  }
  EXPECT_EQ(find_algorithm("no such algorithm"), nullptr);
}

TEST(CatalogTest, TheReferenceIsExactAndTakesWhateverIsAlwaysFeasible) {
  const auto reference = reference_algorithm().make();
  EXPECT_TRUE(reference->traits().exact);
  EXPECT_EQ(reference->traits().answer, Answer::kSelection);
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Shape shape = random_case(seed).problem.shape();
    EXPECT_TRUE(!shape.always_feasible || reference->can_solve(shape).ok);
  }
}

/// The random problems would prove little if they were all alike.
TEST(RandomProblemsTest, CoverTheShapesThatMatter) {
  int infeasible = 0;
  int with_ties = 0;
  int without_columns = 0;
  int exactly_once = 0;
  std::set<int> dimensions;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const Case c = random_case(seed);
    infeasible += optimum(c.problem).has_value() ? 0 : 1;
    with_ties += c.shape.integer_costs ? 1 : 0;
    without_columns += c.problem.columns() == 0 ? 1 : 0;
    exactly_once += c.problem.shape().has_exactly_once_rows ? 1 : 0;
    dimensions.insert(c.shape.dimensions);
  }
  EXPECT_GE(infeasible, 20);
  EXPECT_GE(with_ties, 100);
  EXPECT_GE(without_columns, 10);
  EXPECT_GE(exactly_once, 100);
  EXPECT_EQ(dimensions, (std::set{1, 2, 3, 4, 5, 6}));
}

}  // namespace
}  // namespace mda::testing
