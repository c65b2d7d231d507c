// The sweeps that have a name.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/catalog.h"
#include "harness/sweep.h"
#include "scenarios/static3/sensor_points.h"
#include "scenarios/static3/sensor_scene.h"

namespace mda {
namespace {

using Names = std::vector<std::string>;

std::vector<ScenarioPlan> plans(const Names& names, const std::vector<int>& windows,
                                int replicates) {
  std::vector<ScenarioPlan> result;
  for (const std::string& name : names) {
    result.push_back({.spec = scenario_named(name), .windows = windows, .replicates = replicates});
  }
  return result;
}

std::vector<ScenarioPlan> groups(const std::vector<int>& windows_of_d, int replicates_of_d,
                                 int replicates) {
  std::vector<ScenarioPlan> result = plans({"A", "B", "C"}, {3, 4, 5, 6, 7}, replicates);
  result.push_back(
      {.spec = scenario_named("D"), .windows = windows_of_d, .replicates = replicates_of_d});
  return result;
}

Sweep sweep(std::string name, std::string summary, std::vector<ScenarioPlan> scenarios,
            Names algorithms) {
  Sweep result;
  result.name = std::move(name);
  result.summary = std::move(summary);
  result.scenarios = std::move(scenarios);
  result.algorithms = std::move(algorithms);
  result.driver = reference_algorithm().name;
  return result;
}

ScenarioPlan closed(std::string_view scenario, std::vector<int> windows, Names algorithms) {
  constexpr int kRuns = 50;
  ScenarioPlan plan{.spec = scenario_named(scenario),
                    .windows = std::move(windows),
                    .replicates = kRuns,
                    .algorithms = std::move(algorithms),
                    .closed_loop = true};
  plan.scan_periods_s = {plan.spec.world.scan_period_s};
  return plan;
}

/// The study of Battistelli et al. 2008, section IV: (a) open loop, every algorithm; (b) closed
/// loop at the nominal scan period; (c) closed loop over scan periods and resolutions (figure 9).
Sweep battistelli2008() {
  const Names scenarios = {"battistelli-1", "battistelli-1-dense", "battistelli-1-wide",
                           "battistelli-2", "battistelli-2-radial"};
  Sweep study;
  study.name = "battistelli2008";
  study.summary = "association as flow: gaps, closed loop and figure 9 of Battistelli et al. 2008";
  study.driver = reference_algorithm().name;
  for (const CatalogEntry& entry : catalog()) {
    if (!entry.make()->traits().needs_sensors) study.algorithms.emplace_back(entry.name);
  }
  for (const std::string& name : scenarios) {
    ScenarioPlan open{
        .spec = scenario_named(name), .windows = {1, 2, 3, 4, 5}, .replicates = 4, .every = 4};
    open.scan_periods_s = {open.spec.world.scan_period_s};
    study.scenarios.push_back(std::move(open));
  }
  for (const std::string& name : scenarios) {
    study.scenarios.push_back(closed(
        name, {3}, {"gnn-by-scan", "scf", "scf-tie", "mcf", "sd-exact", "viterbi-sequential"}));
    study.scenarios.push_back(closed(name, {1, 2, 4, 5}, {"scf-tie", "sd-exact"}));
  }
  for (const char* name :
       {"battistelli-2", "battistelli-2-res0.01", "battistelli-2-res2", "battistelli-2-res4"}) {
    study.scenarios.push_back(closed(name, {3}, {"scf-tie", "mcf", "sd-exact"}));
    std::vector<double>& periods = study.scenarios.back().scan_periods_s;
    periods = {1.0, 2.0, 4.0, 5.0, 6.0, 8.0, 10.0};
    if (name == scenarios[3]) std::erase(periods, 2.0);  // part (b) has it
  }
  return study;
}

/// The study of Lee & Jeong 1998, section IV: in closed loop Table 3 (two pairs of targets, four
/// densities) and Table 4 (ten targets), each under both clutter laws; in open loop a few windows
/// of most scenes for gaps and times.
Sweep lee1998(std::string name, std::string summary, int runs, TrackUpdate update) {
  constexpr int kOpenRuns = 4;
  Sweep study;
  study.name = std::move(name);
  study.summary = std::move(summary);
  study.driver = reference_algorithm().name;
  study.scan_periods_s = {1.0};
  const Names single_scan = {
      "gnn",         "nn",    "mapada",    "mapada-literal", "mapada-weighted",
      "mapada-miss", "hnpda", "hnpda-raw", "jpda",           "pda",
      "jpda-cheap",  "lbp"};
  study.algorithms = single_scan;
  study.algorithms.emplace_back(study.driver);
  for (const char* pair : {"lee-crossing", "lee-parallel"}) {
    for (const char* law : {"", "-uniform"}) {
      for (const char* density : {"", "-c0.4", "-c0.6", "-c0.8"}) {
        const std::string scene = fmt::format("{}{}{}", pair, law, density);
        study.scenarios.push_back(closed(scene, {1}, single_scan));
      }
    }
  }
  for (const char* ten : {"lee-ten", "lee-ten-uniform"}) {
    study.scenarios.push_back(closed(ten, {1}, single_scan));
  }
  for (ScenarioPlan& plan : study.scenarios) plan.replicates = runs;
  for (const char* scene :
       {"lee-crossing", "lee-parallel", "lee-parallel-c0.8", "lee-ten", "lee-ten-uniform"}) {
    study.scenarios.push_back(
        {.spec = scenario_named(scene), .windows = {1}, .replicates = kOpenRuns, .every = 4});
  }
  for (ScenarioPlan& plan : study.scenarios) plan.spec.model.update = update;
  return study;
}

/// Figure 2 of Bojilov 1995 with false alarms as a third axis: 1,000 runs of what is fast, and of
/// the first 100 of them everything that takes three dimensions.
Sweep bojilov1995() {
  constexpr int kRuns = 1000;
  constexpr int kRunsOfAll = 100;
  Names fast;
  for (const CatalogEntry& entry : catalog()) {
    if (entry.make()->traits().needs_sensors) fast.emplace_back(entry.name);
  }
  fast.insert(fast.end(), {"exact", "greedy"});
  Sweep study =
      sweep("bojilov1995", "three sensors at one instant: figure 2 of Bojilov 1995", {}, fast);
  for (const char* name : {"cbc", "lp-grp", "lagrangian-sd", "pdhg"}) {
    study.algorithms.emplace_back(name);
  }
  study.scan_periods_s = {1.0};
  for (const ScenarioSpec& point : sensor_grid_points()) {
    study.scenarios.push_back({.spec = point, .windows = {kSensors}, .replicates = kRunsOfAll});
    study.scenarios.push_back({.spec = point,
                               .windows = {kSensors},
                               .replicates = kRuns,
                               .algorithms = fast,
                               .first_replicate = kRunsOfAll + 1});
  }
  return study;
}

/// How long proofs take: the paper's groups; established tracks, in the last of their scans; and
/// all scans of packed targets whose velocity nobody knows.
Sweep certified() {
  constexpr int kDraws = 30;
  Sweep study = sweep("certified", "time to a proven optimum: groups A-D, easy and ladder",
                      plans({"A", "B", "C", "D"}, {3, 5, 7}, 10),
                      {"tree-exact", "dual-ascent", "cg-lp", "lp", "exact", "cbc"});
  for (const char* option : {"lpsolve-bb", "glpk-bb", "cbc-main"}) {
    if (find_algorithm(option) != nullptr) study.algorithms.emplace_back(option);
  }
  study.repeats = 3;
  for (ScenarioPlan& plan : study.scenarios) plan.every = 3;
  const auto add_last_scan = [&](std::string_view scenario, std::vector<int> windows) {
    ScenarioPlan plan{
        .spec = scenario_named(scenario), .windows = std::move(windows), .replicates = kDraws};
    plan.every = plan.spec.world.scans;
    study.scenarios.push_back(std::move(plan));
  };
  add_last_scan("easy-50", {4});
  add_last_scan("easy-100", {5, 6});
  add_last_scan("easy-200", {8});
  for (const char* ladder : {"ladder-40-6", "ladder-40-5", "ladder-40-4", "ladder-60-7",
                             "ladder-100-10", "ladder-40-8", "ladder-40-10"}) {
    add_last_scan(ladder, {scenario_named(ladder).world.scans});
  }
  return study;
}

std::vector<Sweep> make_named_sweeps() {
  const Names paper = {"lp-grp", "cbc", "exact", "greedy"};
  std::vector<Sweep> sweeps;
  sweeps.push_back(sweep("smoke", "a little of everything, a few seconds",
                         plans({"A", "B", "C", "D"}, {3, 5}, 1),
                         {"lp", "lp-grp", "cbc", "exact", "greedy"}));
  sweeps.push_back(sweep("storms2003", "the 4,650 windows of Storms & Spieksma 2003, Tables 2-5",
                         groups({3}, 5, 10), paper));
  sweeps.push_back(sweep("storms2003-100",
                         "the same with 100 scenarios per group, group D also at K = 4 to 7",
                         groups({3, 4, 5, 6, 7}, 100, 100), paper));
  sweeps.push_back(sweep("scan-periods", "what the scan period changes: 2, 4, 8 and 12 s",
                         plans({"A", "B", "C", "D"}, {3, 5, 7}, 10),
                         {"lp-grp", "exact", "greedy"}));
  sweeps.back().scan_periods_s = {2.0, 4.0, 8.0, 12.0};
  sweeps.push_back(sweep("storms2003-gate16", "groups A-C with a gate of 16 instead of 9.21",
                         plans({"A", "B", "C"}, {3, 4, 5, 6, 7}, 10), {"lp-grp", "exact"}));
  for (ScenarioPlan& plan : sweeps.back().scenarios) plan.spec.model.gate = 16.0;
  sweeps.push_back(
      sweep("storms2003-wide", "groups A-C with ever wider windows, up to all 30 scans: model (9)",
            plans({"A", "B", "C"}, {5, 7, 10, 15, 20, 30}, 3), {"lp-grp", "exact", "tree-exact"}));
  sweeps.push_back(battistelli2008());
  sweeps.push_back(lee1998("lee1998", "single-scan association: Tables 3 and 4 of Lee & Jeong 1998",
                           40, TrackUpdate::kSoft));
  sweeps.push_back(lee1998("lee1998-400", "the same with 400 runs", 400, TrackUpdate::kSoft));
  sweeps.push_back(lee1998("lee1998-hard", "lee1998 with marginals taken by hard decisions", 40,
                           TrackUpdate::kHard));
  sweeps.push_back(bojilov1995());
  sweeps.push_back(certified());
  return sweeps;
}

}  // namespace

const std::vector<Sweep>& named_sweeps() {
  static const std::vector<Sweep> kSweeps = make_named_sweeps();
  return kSweeps;
}

}  // namespace mda
