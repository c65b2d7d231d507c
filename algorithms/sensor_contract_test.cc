// Every entry of the catalogue that works on the reports of three sensors against the laws of its
// traits, on windows that come with them; and the others, which see the same windows as columns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/contract.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_sensors.h"

namespace mda::testing {
namespace {

std::vector<CatalogEntry> entries_with_sensors() {
  std::vector<CatalogEntry> entries;
  std::copy_if(catalog().begin(), catalog().end(), std::back_inserter(entries),
               [](const CatalogEntry& entry) { return entry.make()->traits().needs_sensors; });
  return entries;
}

class SensorContractTest : public ::testing::TestWithParam<CatalogEntry> {};

TEST_P(SensorContractTest, DeclinesProblemsWithoutSensors) {
  const Verdict verdict = GetParam().make()->can_solve(Shape{});
  EXPECT_FALSE(verdict.ok);
  EXPECT_FALSE(verdict.reason.empty());
}

TEST_P(SensorContractTest, OrderOfReportsDoesNotMatter) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_sensor_problem(seed);
    ASSERT_TRUE(GetParam().make()->can_solve(problem.shape()).ok);
    for (const std::uint64_t order : {1, 2}) {
      expect_order_does_not_matter(GetParam().make, problem, random_sensor_problem(seed, order));
    }
  }
}

TEST_P(SensorContractTest, NoMemoryBetweenCalls) {
  for (std::uint64_t seed = 301; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    expect_no_memory(GetParam().make, random_sensor_problem(seed), random_sensor_problem(seed + 1));
  }
}

TEST_P(SensorContractTest, ThreadsDoNotDisturbEachOther) {
  std::vector<AssociationProblem> problems;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) problems.push_back(random_sensor_problem(seed));
  expect_threads_apart(GetParam().make, problems);
}

TEST_P(SensorContractTest, HonestDeadlines) {
  for (std::uint64_t seed = 401; seed <= 460; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_sensor_problem(seed);
    const auto best = optimum(problem);
    for (const int microseconds : {-1, 1, 3, 10, 30, 100}) {
      expect_honest_deadline(GetParam().make, problem, best, microseconds);
    }
  }
}

std::string test_name(const ::testing::TestParamInfo<CatalogEntry>& info) {
  std::string name(info.param.name);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Catalog, SensorContractTest, ::testing::ValuesIn(entries_with_sensors()),
                         test_name);

TEST(SensorWindowsTest, EverybodyAnswersLawfullyOrDeclines) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_sensor_problem(seed);
    const auto best = optimum(problem);
    for (const CatalogEntry& entry : catalog()) {
      SCOPED_TRACE(entry.name);
      expect_lawful_answer(entry.make, problem, best);
    }
  }
}

TEST(SensorWindowsTest, TheyHaveNoTree) {
  const Shape shape = random_sensor_problem(1).shape();
  EXPECT_TRUE(shape.has_sensors);
  EXPECT_FALSE(shape.has_tree);
  EXPECT_EQ(shape.dimensions, 3);
}

}  // namespace
}  // namespace mda::testing
