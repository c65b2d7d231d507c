#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "algorithms/catalog.h"
#include "harness/errors.h"
#include "harness/files.h"
#include "harness/sweep.h"
#include "scenarios/duration.h"
#include "scenarios/groups.h"
#include "scenarios/static3/sensor_scene.h"

namespace mda {
namespace {

using Names = std::vector<std::string>;

template <typename List, typename Name>
std::string joined(const List& list, Name name) {
  std::string text;
  for (const auto& item : list) text += (text.empty() ? "" : ", ") + std::string(name(item));
  return text;
}

template <typename T>
void check_list(const std::vector<T>& list, const std::string& what) {
  if (list.empty()) throw InputError(what + ": nothing is listed");
  if (std::set<T>(list.begin(), list.end()).size() != list.size()) {
    throw InputError(what + ": something is listed twice");
  }
}

/// Three sensors at one instant.
void check_sensors(const ScenarioPlan& plan, const std::string& of) {
  if (const std::string fault = sensor_fault(plan.spec); !fault.empty()) {
    throw InputError(of + fault);
  }
  if (plan.windows != std::vector<int>{kSensors}) {
    throw InputError(
        fmt::format("{}windows: three sensors make one window of K = {}", of, kSensors));
  }
  if (plan.closed_loop) throw InputError(of + "one instant has no closed loop");
}

void check_plan(const ScenarioPlan& plan, const std::string& where) {
  const std::string of = where + "scenario " + plan.spec.name + ": ";
  check_list(plan.windows, of + "windows");
  if (plan.spec.three_sensors) check_sensors(plan, of);
  for (const int k : plan.windows) {
    if (plan.spec.three_sensors) break;  // scans do not count

    if (k < 1 || k > plan.spec.world.scans) {
      throw InputError(
          fmt::format("{}window {}: it must be 1 to {} scans", of, k, plan.spec.world.scans));
    }
    if (k > 1 && plan.spec.position_targets) {
      throw InputError(
          fmt::format("{}window {}: its scans are associated one by one, so it must be 1", of, k));
    }
  }
  if (plan.replicates < 1 || plan.replicates > 1000000) {
    throw InputError(fmt::format("{}replicates {}: it must be 1 to 1000000", of, plan.replicates));
  }
  if (plan.first_replicate < 1 || plan.first_replicate > plan.replicates) {
    throw InputError(fmt::format("{}first replicate {}: it must be 1 to {}", of,
                                 plan.first_replicate, plan.replicates));
  }
  if (plan.every < 1 || plan.every > 1000000) {
    throw InputError(fmt::format("{}every {}: it must be 1 to 1000000", of, plan.every));
  }
}

void check_algorithm(const std::string& name, const std::string& where) {
  if (find_algorithm(name) != nullptr) return;
  throw InputError(fmt::format("{}unknown algorithm '{}': there are {}", where, name,
                               joined(catalog(), [](const auto& e) { return e.name; })));
}

/// Where trajectories are given, the scan period decides how many scans there are.
void check_given_scans(const Sweep& sweep, const ScenarioPlan& plan, const std::string& where) {
  constexpr double kMostScans = 10000.0;
  const std::optional<double> seconds = duration_s(plan.spec);
  if (!seconds) return;
  const int widest = *std::max_element(plan.windows.begin(), plan.windows.end());
  for (const double period : scan_periods_of(sweep, plan)) {
    if (*seconds / period > kMostScans || *seconds / period < widest) {
      throw InputError(fmt::format(
          "{}scenario {}: scan period {}: its {} s must hold {} scans (the widest window) to {}",
          where, plan.spec.name, period, *seconds, widest, kMostScans));
    }
  }
}

void check_algorithms(const Names& names, const std::string& where) {
  check_list(names, where + "algorithms");
  for (const std::string& name : names) check_algorithm(name, where);
}

void check_scan_periods(const std::vector<double>& periods_s, const std::string& where) {
  check_list(periods_s, where + "scan periods");
  for (const double t : periods_s) {
    if (!(t > 0.0) || t > 3600.0) {
      throw InputError(
          fmt::format("{}scan period {}: it must be above 0 and at most 3600 s", where, t));
    }
  }
}

/// Scenario, whether in closed loop, scan period, K: what tells the cells of a replicate apart.
using CellKey = std::tuple<std::string, bool, double, int>;

std::vector<CellKey> cells_of(const Sweep& sweep, const ScenarioPlan& plan) {
  std::vector<CellKey> cells;
  for (const double period : scan_periods_of(sweep, plan)) {
    for (const int k : plan.windows) {
      cells.emplace_back(plan.spec.name, plan.closed_loop, period, k);
    }
  }
  return cells;
}

/// Which cells there are already, and of which replicates.
class SeenCells {
 public:
  /// False if one of the plan's replicates of this cell was there before.
  bool insert(const CellKey& cell, const ScenarioPlan& plan) {
    auto& ranges = ranges_[cell];
    const bool is_new = std::ranges::none_of(ranges, [&](const auto& range) {
      return plan.first_replicate <= range.second && range.first <= plan.replicates;
    });
    ranges.emplace_back(plan.first_replicate, plan.replicates);
    return is_new;
  }

 private:
  std::map<CellKey, std::vector<std::pair<int, int>>> ranges_;
};

void check_cells(const Sweep& sweep, const std::string& where) {
  SeenCells seen;
  for (const ScenarioPlan& plan : sweep.scenarios) {
    for (const CellKey& cell : cells_of(sweep, plan)) {
      if (seen.insert(cell, plan)) continue;
      throw InputError(fmt::format("{}scenarios: something is listed twice, {} at {} s, K = {}",
                                   where, plan.spec.name, std::get<2>(cell), std::get<3>(cell)));
    }
  }
}

/// After changes of the command line, parts of a scenario may ask for the same cells.
void drop_repeated_cells(Sweep& sweep) {
  SeenCells seen;
  std::erase_if(sweep.scenarios, [&](const ScenarioPlan& plan) {
    const std::vector<CellKey> cells = cells_of(sweep, plan);
    const auto repeated =
        std::ranges::count_if(cells, [&](const CellKey& c) { return !seen.insert(c, plan); });
    return !cells.empty() && repeated == std::ssize(cells);
  });
}

/// Ends every scenario with replicate `last`: parts that begin later go, those that another part
/// continues do not grow.
void end_replicates(std::vector<ScenarioPlan>& plans, int last) {
  std::erase_if(plans, [&](const ScenarioPlan& p) { return last > 0 && p.first_replicate > last; });
  for (ScenarioPlan& plan : plans) {
    const bool goes_on = std::ranges::any_of(plans, [&](const ScenarioPlan& other) {
      return other.spec.name == plan.spec.name && other.first_replicate == plan.replicates + 1;
    });
    if (!goes_on || last < plan.replicates) plan.replicates = last;
  }
}

/// The plans of the scenarios of these names; one that has none gets the first plan's settings.
std::vector<ScenarioPlan> plans_of(const std::vector<ScenarioPlan>& plans, const Names& names) {
  check_list(names, "scenarios");
  std::vector<ScenarioPlan> wanted;
  for (const std::string& name : names) {
    const auto before = wanted.size();
    for (const ScenarioPlan& plan : plans) {
      if (plan.spec.name == name) wanted.push_back(plan);
    }
    if (wanted.size() > before) continue;
    ScenarioPlan& plan = wanted.emplace_back(plans.front());
    plan.spec = scenario_named(name);
    plan.scan_periods_s.clear();
    if (duration_s(plan.spec)) plan.scan_periods_s = {plan.spec.world.scan_period_s};
  }
  return wanted;
}

}  // namespace

const ScenarioSpec& scenario_named(std::string_view name, std::string_view where) {
  if (const ScenarioSpec* spec = find_scenario(name)) return *spec;
  throw InputError(fmt::format("{}unknown scenario '{}': there are {}", where, name,
                               joined(scenario_list(), [](const auto& s) { return s.name; })));
}

Sweep load_sweep(const std::string& name) {
  if (name.ends_with(".toml")) return parse_sweep(read_regular_file(name), name);
  for (const Sweep& sweep : named_sweeps()) {
    if (sweep.name == name) return sweep;
  }
  throw InputError(fmt::format("unknown sweep '{}': there are {}, or give a .toml file", name,
                               joined(named_sweeps(), [](const auto& s) { return s.name; })));
}

const std::vector<double>& scan_periods_of(const Sweep& sweep, const ScenarioPlan& plan) {
  return plan.scan_periods_s.empty() ? sweep.scan_periods_s : plan.scan_periods_s;
}

const std::vector<std::string>& algorithms_of(const Sweep& sweep, const ScenarioPlan& plan) {
  return plan.algorithms.empty() ? sweep.algorithms : plan.algorithms;
}

Sweep changed(Sweep sweep, const SweepChanges& changes) {
  if (!changes.scenarios.empty()) {
    sweep.scenarios = plans_of(sweep.scenarios, changes.scenarios);
  }
  if (changes.replicates != 0) end_replicates(sweep.scenarios, changes.replicates);
  for (ScenarioPlan& plan : sweep.scenarios) {
    if (!changes.windows.empty()) plan.windows = changes.windows;
    if (!changes.algorithms.empty()) plan.algorithms.clear();
    if (!changes.scan_periods_s.empty()) plan.scan_periods_s.clear();
    plan.closed_loop = plan.closed_loop || changes.closed_loop;
  }
  if (!changes.algorithms.empty()) sweep.algorithms = changes.algorithms;
  if (!changes.scan_periods_s.empty()) sweep.scan_periods_s = changes.scan_periods_s;
  if (changes.seed != 0) sweep.seed = changes.seed;
  if (changes.time_limit_s != 0.0) sweep.time_limit_s = changes.time_limit_s;
  if (changes.repeats != 0) sweep.repeats = changes.repeats;
  drop_repeated_cells(sweep);
  check(sweep, "");
  return sweep;
}

void check(const Sweep& sweep, const std::string& where) {
  if (sweep.scenarios.empty()) throw InputError(where + "scenarios: nothing is listed");
  for (const ScenarioPlan& plan : sweep.scenarios) {
    check_plan(plan, where);
    check_algorithms(algorithms_of(sweep, plan), where);
    check_scan_periods(scan_periods_of(sweep, plan), where);
    check_given_scans(sweep, plan, where);
  }
  check_algorithm(sweep.driver, where + "driver: ");
  check_cells(sweep, where);
  if (!(sweep.time_limit_s > 0.0) || !std::isfinite(sweep.time_limit_s)) {
    throw InputError(
        fmt::format("{}time limit {}: it must be above 0 s", where, sweep.time_limit_s));
  }
  if (sweep.repeats < 1 || sweep.repeats > kMostRepeats) {
    throw InputError(
        fmt::format("{}repeats {}: it must be 1 to {}", where, sweep.repeats, kMostRepeats));
  }
}

}  // namespace mda
