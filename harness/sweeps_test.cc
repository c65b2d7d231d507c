#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <tuple>

#include "algorithms/catalog.h"
#include "harness/errors.h"
#include "harness/plan.h"
#include "harness/sweep.h"

namespace mda::testing {
namespace {

using Strings = std::vector<std::string>;
using Change = std::function<void(SweepChanges&)>;

Sweep changed_sweep(const std::string& name, const Change& change) {
  SweepChanges changes;
  change(changes);
  return changed(load_sweep(name), changes);
}

const ScenarioPlan& plan_of(const Sweep& sweep, const std::string& scenario) {
  const auto found = std::find_if(sweep.scenarios.begin(), sweep.scenarios.end(),
                                  [&](const ScenarioPlan& p) { return p.spec.name == scenario; });
  if (found == sweep.scenarios.end()) throw std::out_of_range(scenario);
  return *found;
}

int windows_of(const Sweep& sweep) {
  int windows = 0;
  for (const Cell& cell : plan(sweep)) windows += cell.plan->spec.world.scans;
  return windows;
}

TEST(SweepsTest, NamedSweepsAreSoundAndFoundByName) {
  std::set<std::string> names;
  for (const Sweep& sweep : named_sweeps()) {
    EXPECT_NO_THROW(check(sweep, "")) << sweep.name;
    EXPECT_FALSE(sweep.summary.empty()) << sweep.name;
    EXPECT_EQ(sweep.driver, reference_algorithm().name);
    EXPECT_EQ(sweep.seed, 1U);
    EXPECT_EQ(load_sweep(sweep.name).summary, sweep.summary);
    names.insert(sweep.name);
  }
  EXPECT_EQ(names.size(), named_sweeps().size());
  EXPECT_TRUE(names.contains("smoke"));
}

TEST(SweepsTest, Storms2003IsThePapersGrid) {
  const Sweep sweep = load_sweep("storms2003");
  EXPECT_EQ(windows_of(sweep), 4650);
  for (const char* group : {"A", "B", "C"}) {
    EXPECT_EQ(plan_of(sweep, group).windows, (std::vector<int>{3, 4, 5, 6, 7}));
    EXPECT_EQ(plan_of(sweep, group).replicates, 10);
  }
  EXPECT_EQ(plan_of(sweep, "D").windows, std::vector<int>{3});
  EXPECT_EQ(plan_of(sweep, "D").replicates, 5);
  EXPECT_EQ(sweep.scan_periods_s, std::vector<double>{8.0});
  EXPECT_EQ(sweep.algorithms, (Strings{"lp-grp", "cbc", "exact", "greedy"}));
}

TEST(SweepsTest, TheLargerGridsAreWhatTheySay) {
  const Sweep hundred = load_sweep("storms2003-100");
  EXPECT_EQ(windows_of(hundred), 4 * 100 * 5 * 30);
  EXPECT_EQ(plan_of(hundred, "D").windows, (std::vector<int>{3, 4, 5, 6, 7}));
  const Sweep periods = load_sweep("scan-periods");
  EXPECT_EQ(periods.scan_periods_s, (std::vector<double>{2.0, 4.0, 8.0, 12.0}));
  EXPECT_EQ(periods.scenarios.size(), 4U);
  for (const ScenarioPlan& p : periods.scenarios) EXPECT_EQ(p.windows, (std::vector<int>{3, 5, 7}));
}

TEST(SweepsTest, ThePlanHasEveryCellOnce) {
  const Sweep sweep = changed_sweep("scan-periods", [](auto& c) { c.replicates = 3; });
  std::set<std::tuple<std::string, double, int, int>> cells;
  for (const Cell& cell : plan(sweep)) {
    cells.insert({cell.plan->spec.name, cell.scan_period_s, cell.replicate, cell.window_k});
    EXPECT_EQ(scenario_of(cell).world.scan_period_s, cell.scan_period_s);
  }
  EXPECT_EQ(cells.size(), plan(sweep).size());
  for (const char* scenario : {"A", "B", "C", "D"}) {
    for (const double period : sweep.scan_periods_s) {
      for (int replicate = 1; replicate <= 3; ++replicate) {
        for (const int k : {3, 5, 7}) {
          EXPECT_TRUE(cells.contains({scenario, period, replicate, k}));
        }
      }
    }
  }
}

/// Scenario, loop, scan period, K and algorithm of all that a sweep does.
std::set<std::tuple<std::string, bool, double, int, std::string>> outings_of(const Sweep& sweep) {
  std::set<std::tuple<std::string, bool, double, int, std::string>> outings;
  for (const Cell& cell : plan(sweep)) {
    for (const std::string& name : algorithms_of(sweep, *cell.plan)) {
      outings.emplace(cell.plan->spec.name, cell.plan->closed_loop, cell.scan_period_s,
                      cell.window_k, name);
    }
  }
  return outings;
}

TEST(SweepsTest, TheStudyOfFlowHasItsThreeParts) {
  const auto outings = outings_of(load_sweep("battistelli2008"));
  for (const auto& [scenario, period] :
       std::map<std::string, double>{{"battistelli-1", 5.0},
                                     {"battistelli-1-dense", 5.0},
                                     {"battistelli-1-wide", 5.0},
                                     {"battistelli-2", 2.0},
                                     {"battistelli-2-radial", 2.0}}) {
    SCOPED_TRACE(scenario);
    for (const CatalogEntry& entry : catalog()) {
      if (entry.make()->traits().needs_sensors) continue;
      for (int k = 1; k <= 5; ++k) {
        EXPECT_TRUE(outings.contains({scenario, false, period, k, std::string(entry.name)}));
      }
    }
    for (const char* name : {"gnn-by-scan", "scf", "mcf", "viterbi-sequential"}) {
      EXPECT_TRUE(outings.contains({scenario, true, period, 3, name}));
    }
    for (int k = 1; k <= 5; ++k) {
      EXPECT_TRUE(outings.contains({scenario, true, period, k, "scf-tie"}));
      EXPECT_TRUE(outings.contains({scenario, true, period, k, "sd-exact"}));
    }
  }
  for (const char* scenario :
       {"battistelli-2-res0.01", "battistelli-2", "battistelli-2-res2", "battistelli-2-res4"}) {
    for (const double period : {1.0, 2.0, 4.0, 5.0, 6.0, 8.0, 10.0}) {
      for (const char* name : {"scf-tie", "mcf", "sd-exact"}) {
        EXPECT_TRUE(outings.contains({scenario, true, period, 3, name}));
      }
    }
  }
}

TEST(SweepsTest, TheStudyOfSingleScansHasBothTables) {
  for (const auto& [name, runs, update] : {std::tuple("lee1998", 40, TrackUpdate::kSoft),
                                           std::tuple("lee1998-400", 400, TrackUpdate::kSoft),
                                           std::tuple("lee1998-hard", 40, TrackUpdate::kHard)}) {
    SCOPED_TRACE(name);
    const Sweep sweep = load_sweep(name);
    const auto outings = outings_of(sweep);
    for (const std::string scene : {"lee-crossing", "lee-parallel"}) {
      for (const std::string law : {"", "-uniform"}) {
        for (const std::string density : {"", "-c0.4", "-c0.6", "-c0.8"}) {
          EXPECT_TRUE(
              outings.contains({fmt::format("{}{}{}", scene, law, density), true, 1.0, 1, "gnn"}));
        }
      }
    }
    for (const char* scene : {"lee-ten", "lee-ten-uniform"}) {
      EXPECT_TRUE(outings.contains({scene, true, 1.0, 1, "nn"}));
      EXPECT_TRUE(outings.contains({scene, false, 1.0, 1, "gnn"}));
    }
    for (const ScenarioPlan& plan : sweep.scenarios) {
      EXPECT_EQ(plan.spec.model.update, update);
      EXPECT_EQ(plan.replicates, plan.closed_loop ? runs : 4);
    }
  }
}

TEST(SweepsTest, AnotherWindowWidthDoesNotAskForACellTwice) {
  const Sweep sweep = changed_sweep("battistelli2008", [](SweepChanges& c) { c.windows = {3}; });
  std::set<std::tuple<std::string, bool, double, int, int>> cells;
  for (const Cell& cell : plan(sweep)) {
    EXPECT_TRUE(cells
                    .insert({cell.plan->spec.name, cell.plan->closed_loop, cell.scan_period_s,
                             cell.replicate, cell.window_k})
                    .second);
  }
}

TEST(SweepsTest, NoChangesChangeNothing) {
  const Sweep sweep = load_sweep("storms2003");
  const Sweep same = changed(sweep, {});
  EXPECT_EQ(windows_of(same), windows_of(sweep));
  EXPECT_EQ(same.algorithms, sweep.algorithms);
  EXPECT_EQ(same.scan_periods_s, sweep.scan_periods_s);
  EXPECT_EQ(same.seed, sweep.seed);
  EXPECT_EQ(same.time_limit_s, sweep.time_limit_s);
}

TEST(SweepsTest, EveryChangeReplacesTheSweepsOwn) {
  const Sweep sweep = changed_sweep("storms2003", [](SweepChanges& c) {
    c.algorithms = {"greedy", "lp"};
    c.scenarios = {"D", "A"};
    c.windows = {2, 9};
    c.scan_periods_s = {4.0, 2.5};
    c.replicates = 7;
    c.seed = 99;
    c.time_limit_s = 0.25;
  });
  EXPECT_EQ(sweep.algorithms, (Strings{"greedy", "lp"}));
  ASSERT_EQ(sweep.scenarios.size(), 2U);
  for (const ScenarioPlan& p : sweep.scenarios) {
    EXPECT_EQ(p.windows, (std::vector<int>{2, 9}));
    EXPECT_EQ(p.replicates, 7);
  }
  EXPECT_EQ(sweep.scan_periods_s, (std::vector<double>{4.0, 2.5}));
  EXPECT_EQ(sweep.seed, 99U);
  EXPECT_EQ(sweep.time_limit_s, 0.25);
  EXPECT_EQ(sweep.name, "storms2003");
}

TEST(SweepsTest, ChosenScenariosKeepTheirOwnPlan) {
  const Sweep sweep = changed_sweep("storms2003", [](auto& c) { c.scenarios = {"D", "B"}; });
  EXPECT_EQ(plan_of(sweep, "D").windows, std::vector<int>{3});
  EXPECT_EQ(plan_of(sweep, "D").replicates, 5);
  EXPECT_EQ(plan_of(sweep, "B").replicates, 10);
}

TEST(SweepsTest, AScenarioThatIsNewToTheSweepGetsThePlanOfTheFirst) {
  Sweep sweep = load_sweep("storms2003");
  std::erase_if(sweep.scenarios, [](const ScenarioPlan& p) { return p.spec.name == "D"; });
  SweepChanges changes;
  changes.scenarios = {"D"};
  sweep = changed(sweep, changes);
  EXPECT_EQ(plan_of(sweep, "D").windows, (std::vector<int>{3, 4, 5, 6, 7}));
  EXPECT_EQ(plan_of(sweep, "D").replicates, 10);
}

/// The message with which the change to storms2003 is refused.
std::string refusal(const Change& change) {
  try {
    static_cast<void>(changed_sweep("storms2003", change));
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(SweepsTest, BadChangesAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<Change, const char*>> cases = {
      {[=](auto& c) { c.algorithms = {"simplex"}; }, "unknown algorithm 'simplex'"},
      {[=](auto& c) { c.algorithms = {""}; }, "unknown algorithm ''"},
      {[=](auto& c) {
         c.algorithms = {"lp", "lp"};
       },
       "algorithms: something is listed twice"},
      {[=](auto& c) { c.scenarios = {"Q"}; }, "unknown scenario 'Q'"},
      {[=](auto& c) {
         c.scenarios = {"A", "A"};
       },
       "scenarios: something is listed twice"},
      {[=](auto& c) { c.windows = {0}; }, "window 0"},
      {[=](auto& c) { c.windows = {-3}; }, "window -3"},
      {[=](auto& c) { c.windows = {31}; }, "window 31"},
      {[=](auto& c) {
         c.windows = {3, 3};
       },
       "windows: something is listed twice"},
      {[=](auto& c) { c.scan_periods_s = {0.0}; }, "scan period 0"},
      {[=](auto& c) { c.scan_periods_s = {-8.0}; }, "scan period -8"},
      {[=](auto& c) { c.scan_periods_s = {3601.0}; }, "scan period 3601"},
      {[=](auto& c) { c.scan_periods_s = {nan}; }, "scan period nan"},
      {[=](auto& c) {
         c.scan_periods_s = {8.0, 8.0};
       },
       "scan periods: something is listed twice"},
      {[=](auto& c) {
         c.scenarios = {"battistelli-1"};
         c.scan_periods_s = {301.0};
       },
       "its 300 s must hold"},
      {[=](auto& c) {
         c.scenarios = {"battistelli-1"};
         c.scan_periods_s = {0.01};
       },
       "its 300 s must hold"},
      {[=](auto& c) { c.scenarios = {"lee-ten"}; },
       "window 3: its scans are associated one by one"},
      {[=](auto& c) {
         c.scenarios = {"lee-ten"};
         c.windows = {1};
         c.scan_periods_s = {41.0};
       },
       "its 40 s must hold"},
      {[=](auto& c) { c.replicates = -1; }, "replicates -1"},
      {[=](auto& c) { c.replicates = 1000001; }, "replicates 1000001"},
      {[=](auto& c) { c.time_limit_s = -1.0; }, "time limit -1"},
      {[=](auto& c) { c.time_limit_s = nan; }, "time limit nan"},
      {[=](auto& c) { c.time_limit_s = infinity; }, "time limit inf"},
  };
  for (const auto& [change, message] : cases) {
    EXPECT_NE(refusal(change).find(message), std::string::npos) << refusal(change);
  }
}

TEST(SweepsTest, EveryNoScanIsRefused) {
  Sweep sweep = load_sweep("smoke");
  for (const int every : {0, -1, 1000001}) {
    sweep.scenarios[0].every = every;
    EXPECT_THROW(check(sweep, ""), InputError) << every;
  }
}

TEST(SweepsTest, UnknownNamesAreAnsweredWithTheKnownOnes) {
  for (const char* name : {"storms", "", "storms2003 ", "STORMS2003"}) {
    try {
      static_cast<void>(load_sweep(name));
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("storms2003-100"), std::string::npos);
    }
  }
  EXPECT_NE(refusal([](auto& c) { c.algorithms = {"x"}; }).find("lp-grp"), std::string::npos);
  EXPECT_NE(refusal([](auto& c) { c.scenarios = {"x"}; }).find("A, B, C, D"), std::string::npos);
}

TEST(SweepsTest, ChecksWhatNoCommandLineSaid) {
  Sweep sweep = load_sweep("smoke");
  sweep.driver = "nobody";
  EXPECT_THROW(check(sweep, ""), InputError);
  sweep = load_sweep("smoke");
  sweep.scenarios.clear();
  EXPECT_THROW(check(sweep, ""), InputError);
  sweep = load_sweep("smoke");
  sweep.scenarios[1].windows.clear();
  EXPECT_THROW(check(sweep, ""), InputError);
}

}  // namespace
}  // namespace mda::testing
