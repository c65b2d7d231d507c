// Sweeps over three sensors at one instant, and scenarios in parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "harness/errors.h"
#include "harness/plan.h"
#include "harness/sweep.h"

namespace mda::testing {
namespace {

using Strings = std::vector<std::string>;

Sweep changed_sweep(const std::function<void(SweepChanges&)>& change) {
  SweepChanges changes;
  change(changes);
  return changed(load_sweep("bojilov1995"), changes);
}

TEST(SensorSweepsTest, TheStudyOfThreeSensorsHasTwoPartsPerPoint) {
  const Sweep sweep = load_sweep("bojilov1995");
  std::map<std::string, std::map<std::string, int>> runs;
  std::set<std::pair<std::string, int>> cells;
  for (const Cell& cell : plan(sweep)) {
    EXPECT_EQ(cell.window_k, 3);
    EXPECT_TRUE(cells.emplace(cell.plan->spec.name, cell.replicate).second) << "drawn twice";
    for (const std::string& name : algorithms_of(sweep, *cell.plan)) {
      ++runs[cell.plan->spec.name][name];
    }
  }
  EXPECT_EQ(runs.size(), 30U);
  EXPECT_EQ(cells.size(), 30U * 1000U);
  for (auto& [point, counts] : runs) {
    EXPECT_GE(counts.size(), 14U);
    for (const auto& [name, count] : counts) {
      const bool fast = name.starts_with("bojilov") || name == "exact" || name == "greedy";
      EXPECT_EQ(count, fast ? 1000 : 100) << name;
    }
  }
}

TEST(SensorSweepsTest, PartsOfAScenarioEndWithTheReplicatesAskedFor) {
  for (const int last : {1, 50, 100, 101, 1000, 2000}) {
    const Sweep sweep = changed_sweep([=](auto& c) {
      c.scenarios = {"static3-36-s0.20-f0.1"};
      c.replicates = last;
    });
    int exact = 0;
    int cbc = 0;
    for (const Cell& cell : plan(sweep)) {
      const Strings& names = algorithms_of(sweep, *cell.plan);
      exact += std::count(names.begin(), names.end(), "exact") > 0 ? 1 : 0;
      cbc += std::count(names.begin(), names.end(), "cbc") > 0 ? 1 : 0;
    }
    EXPECT_EQ(exact, last);
    EXPECT_EQ(cbc, std::min(last, 100));
  }
}

TEST(SensorSweepsTest, PartsThatOverlapAreRefused) {
  Sweep sweep = load_sweep("bojilov1995");
  sweep.scenarios[1].first_replicate = 100;
  EXPECT_THROW(check(sweep, ""), InputError);
  sweep.scenarios[1].first_replicate = 1001;
  EXPECT_THROW(check(sweep, ""), InputError);
}

TEST(SensorSweepsTest, OneInstantHasOneWindowAndNoClosedLoop) {
  EXPECT_THROW(static_cast<void>(changed_sweep([](auto& c) { c.windows = {4}; })), InputError);
  EXPECT_THROW(static_cast<void>(changed_sweep([](auto& c) { c.closed_loop = true; })), InputError);
}

}  // namespace
}  // namespace mda::testing
