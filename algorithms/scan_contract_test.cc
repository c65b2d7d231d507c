// Every entry of the catalogue that works on the pairs of one scan against the laws of its traits,
// on scans that come with them.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/contract.h"
#include "algorithms/testing/entry_name.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_pair_scans.h"

namespace mda::testing {
namespace {

AssociationProblem scan(std::uint64_t seed, std::uint64_t order = 0) {
  return random_pair_scan(random_pair_scan_shape(seed), seed, order);
}

std::vector<CatalogEntry> entries_with_pairs() {
  std::vector<CatalogEntry> entries;
  std::copy_if(catalog().begin(), catalog().end(), std::back_inserter(entries),
               [](const CatalogEntry& entry) { return entry.make()->traits().needs_pairs; });
  return entries;
}

class ScanContractTest : public ::testing::TestWithParam<CatalogEntry> {};

TEST_P(ScanContractTest, DeclinesProblemsWithoutPairs) {
  const Verdict verdict = GetParam().make()->can_solve(Shape{});
  EXPECT_FALSE(verdict.ok);
  EXPECT_FALSE(verdict.reason.empty());
}

TEST_P(ScanContractTest, TakesEveryScan) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    EXPECT_TRUE(GetParam().make()->can_solve(scan(seed).shape()).ok);
  }
}

TEST_P(ScanContractTest, LawfulAnswers) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = scan(seed);
    expect_lawful_answer(GetParam().make, problem, optimum(problem));
  }
}

TEST_P(ScanContractTest, NoTracksNoPlotsNoPairs) {
  for (const PairScanShape& shape :
       {PairScanShape{.tracks = 0, .plots = 0}, PairScanShape{.tracks = 0},
        PairScanShape{.plots = 0}, PairScanShape{.gate = -1.0},
        PairScanShape{.plots = 0, .must_go_on = false}}) {
    const AssociationProblem problem = random_pair_scan(shape, 1);
    expect_lawful_answer(GetParam().make, problem, optimum(problem));
  }
}

TEST_P(ScanContractTest, OrderDoesNotMatter) {
  for (std::uint64_t seed = 1001; seed <= 1500; ++seed) {
    SCOPED_TRACE(seed);
    for (const std::uint64_t order : {1, 2}) {
      expect_order_does_not_matter(GetParam().make, scan(seed), scan(seed, order));
    }
  }
}

/// Columns of a scan differ in cost, but for their order.
std::vector<int> columns_by_cost(const AssociationProblem& problem) {
  std::vector<int> columns(problem.costs().size());
  std::iota(columns.begin(), columns.end(), 0);
  std::sort(columns.begin(), columns.end(),
            [&](int a, int b) { return problem.cost(a) < problem.cost(b); });
  return columns;
}

TEST_P(ScanContractTest, MarginalsFollowTheirColumns) {
  for (std::uint64_t seed = 1001; seed <= 1500; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem plain = scan(seed);
    const AssociationProblem reordered = scan(seed, 1);
    const std::vector<int> from = columns_by_cost(plain);
    const std::vector<int> to = columns_by_cost(reordered);
    std::vector<int> column_to(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
      column_to[static_cast<std::size_t>(from[i])] = to[i];
    }
    expect_marginals_follow(GetParam().make, plain, reordered, column_to);
  }
}

TEST_P(ScanContractTest, NoMemoryBetweenCalls) {
  for (std::uint64_t seed = 1501; seed <= 1600; ++seed) {
    SCOPED_TRACE(seed);
    expect_no_memory(GetParam().make, scan(seed), scan(seed + 1));
  }
}

TEST_P(ScanContractTest, ThreadsDoNotDisturbEachOther) {
  std::vector<AssociationProblem> problems;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) problems.push_back(scan(seed));
  expect_threads_apart(GetParam().make, problems);
}

TEST_P(ScanContractTest, HonestDeadlines) {
  for (std::uint64_t seed = 1601; seed <= 1660; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = scan(seed);
    const auto best = optimum(problem);
    for (const int microseconds : {-1, 10, 50, 100, 200, 400}) {
      expect_honest_deadline(GetParam().make, problem, best, microseconds);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalog, ScanContractTest, ::testing::ValuesIn(entries_with_pairs()),
                         entry_name);

}  // namespace
}  // namespace mda::testing
