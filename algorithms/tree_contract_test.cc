// Every entry of the catalogue that works on hypothesis trees against the laws of its traits, on
// windows that come with one.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/contract.h"
#include "algorithms/testing/entry_name.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_trees.h"

namespace mda::testing {
namespace {

/// Window number `seed`: known tracks that must go on, known tracks that may be dropped, or tracks
/// that are born too.
TreeShape shape_of(std::uint64_t seed) {
  TreeShape shape = random_tree_shape(seed, seed % 3 == 2);
  if (seed % 3 == 1) shape.must_go_on = false;
  return shape;
}

AssociationProblem window(std::uint64_t seed, std::uint64_t order = 0) {
  return random_tree_problem(shape_of(seed), seed, order);
}

std::vector<CatalogEntry> entries_with_trees() {
  std::vector<CatalogEntry> entries;
  std::copy_if(catalog().begin(), catalog().end(), std::back_inserter(entries),
               [](const CatalogEntry& entry) { return entry.make()->traits().needs_tree; });
  return entries;
}

class TreeContractTest : public ::testing::TestWithParam<CatalogEntry> {};

TEST_P(TreeContractTest, DeclinesProblemsWithoutATree) {
  const Verdict verdict = GetParam().make()->can_solve(Shape{});
  EXPECT_FALSE(verdict.ok);
  EXPECT_FALSE(verdict.reason.empty());
}

TEST_P(TreeContractTest, TakesSomeWindows) {
  int taken = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    taken += GetParam().make()->can_solve(window(seed).shape()).ok ? 1 : 0;
  }
  EXPECT_GE(taken, 10);
}

TEST_P(TreeContractTest, LawfulAnswers) {
  for (std::uint64_t seed = 1; seed <= 240; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = window(seed);
    expect_lawful_answer(GetParam().make, problem, optimum(problem));
  }
}

/// Tracks that may all be dropped, and had better be.
TEST_P(TreeContractTest, WindowsWithoutColumns) {
  TreeShape shape;
  shape.gate_nats = -100.0;
  shape.must_go_on = false;
  for (const int tracks : {0, 1, 3}) {
    shape.tracks = tracks;
    const AssociationProblem problem = random_tree_problem(shape, 1);
    ASSERT_EQ(problem.columns(), 0);
    expect_lawful_answer(GetParam().make, problem, 0.0);
  }
}

TEST_P(TreeContractTest, OrderDoesNotMatter) {
  for (std::uint64_t seed = 301; seed <= 1200; ++seed) {
    SCOPED_TRACE(seed);
    // Without history, two tracks that last took the same plot cost alike from then on: a tie.
    if (shape_of(seed).history == 0.0) continue;
    for (const std::uint64_t order : {1, 2}) {
      expect_order_does_not_matter(GetParam().make, window(seed), window(seed, order));
    }
  }
}

TEST_P(TreeContractTest, NoMemoryBetweenCalls) {
  for (std::uint64_t seed = 601; seed <= 700; ++seed) {
    SCOPED_TRACE(seed);
    expect_no_memory(GetParam().make, window(seed), window(seed + 3));
    expect_no_memory(GetParam().make, window(seed), window(seed + 1));
  }
}

TEST_P(TreeContractTest, ThreadsDoNotDisturbEachOther) {
  std::vector<AssociationProblem> problems;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) problems.push_back(window(seed));
  expect_threads_apart(GetParam().make, problems);
}

TEST_P(TreeContractTest, HonestDeadlines) {
  for (std::uint64_t seed = 701; seed <= 760; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = window(seed);
    const auto best = optimum(problem);
    for (const int microseconds : {-1, 10, 50, 100, 200, 400}) {
      expect_honest_deadline(GetParam().make, problem, best, microseconds);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalog, TreeContractTest, ::testing::ValuesIn(entries_with_trees()),
                         entry_name);

}  // namespace
}  // namespace mda::testing
