#include "harness/manifest.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "harness/build_info.h"
#include "harness/machine.h"
#include "harness/row.h"
#include "harness/spec_json.h"
#include "scenarios/cartesian/trajectories.h"
#include "scenarios/duration.h"
#include "scenarios/known/trajectories.h"

namespace mda {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Sweep& sweep) {
  Json plans = Json::array();
  for (const ScenarioPlan& plan : sweep.scenarios) {
    plans.push_back({{"scenario", plan.spec.name},
                     {"loop", plan.closed_loop ? "closed" : "open"},
                     {"windows", plan.windows},
                     {"replicates", plan.replicates},
                     {"first_replicate", plan.first_replicate},
                     {"scan_periods_s", scan_periods_of(sweep, plan)},
                     {"algorithms", algorithms_of(sweep, plan)},
                     {"every", plan.every}});
  }
  return {{"name", sweep.name},
          {"plans", plans},
          {"scan_periods_s", sweep.scan_periods_s},
          {"seed", sweep.seed},
          {"driver", sweep.driver},
          {"algorithms", sweep.algorithms},
          {"time_limit_s", sweep.time_limit_s},
          {"repeats", sweep.repeats}};
}

Json json_of(const RunRecord& record) {
  const Tally& tally = record.tally;
  return {{"cells", record.cells},
          {"cells_finished", record.cells_finished},
          {"cells_failed", record.cells_failed},
          {"open_loop_cells_failed", record.open_loop_cells_failed},
          {"windows", tally.windows},
          {"rows", tally.rows},
          {"failed", tally.failed},
          {"refuted", tally.refuted},
          {"skipped", tally.skipped},
          {"timed_out", tally.timed_out},
          {"driver_fallbacks", tally.fallbacks},
          {"windows_compared_between_exact_algorithms", tally.compared},
          {"largest_difference_between_exact_algorithms_nats", tally.largest_exact_spread},
          {"simulate_cpu_s", tally.simulate_cpu_ms / 1e3},
          {"hypotheses_cpu_s", tally.hypotheses_cpu_ms / 1e3},
          {"solve_cpu_s", tally.solve_cpu_ms / 1e3},
          {"cells_cpu_s", tally.cell_cpu_ms / 1e3},
          {"cells_wall_s", tally.cell_wall_ms / 1e3},
          {"parallel_s", record.parallel_ms / 1e3},
          {"speed_up", speed_up(record)},
          {"other_share", other_share(record)}};
}

Json libraries() {
  const BuildInfo& build = build_info();
  return {{"cbc", build.cbc_version},
          {"clp", build.clp_version},
          {"eigen", build.eigen_version},
          {"boost", build.boost_version},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
                              FMT_VERSION % 100)}};
}

std::vector<TargetState> states_at(const ScenarioSpec& spec, double time_s) {
  return spec.known_targets ? true_states(*spec.known_targets, time_s)
                            : true_states(*spec.position_targets, time_s);
}

}  // namespace

std::string utc_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

double speed_up(const RunRecord& record) {
  return record.parallel_ms > 0.0 ? record.tally.cell_wall_ms / record.parallel_ms : 0.0;
}

double other_share(const RunRecord& record) {
  const Tally& t = record.tally;
  if (t.cell_cpu_ms <= 0.0) return 0.0;
  const double accounted = t.simulate_cpu_ms + t.hypotheses_cpu_ms + t.solve_cpu_ms;
  return std::max(0.0, 1.0 - accounted / t.cell_cpu_ms);
}

Json manifest(const Sweep& sweep, const RunRecord& record) {
  const BuildInfo& build = build_info();
  Json scenarios = Json::object();
  for (const ScenarioPlan& plan : sweep.scenarios) {
    scenarios[plan.spec.name] = json_of(plan.spec);
  }
  return {{"schema_version", kSchemaVersion},
          {"program", "mda-bench"},
          {"version", build.version},
          {"commit", build.commit},
          {"dirty", build.dirty},
          {"compiler", build.compiler},
          {"flags", build.flags},
          {"libraries", libraries()},
          {"cpu", read_machine("/", "").cpu},
          {"arguments", record.arguments},
          {"workers", record.workers},
          {"sweep", json_of(sweep)},
          {"scenarios", scenarios},
          {"start", record.start},
          {"end", record.end.empty() ? Json(nullptr) : Json(record.end)},
          {"outcome", record.outcome},
          {"summary", json_of(record)}};
}

Json trajectories(const Sweep& sweep) {
  Json all = Json::object();
  for (const ScenarioPlan& plan : sweep.scenarios) {
    const ScenarioSpec& spec = plan.spec;
    if (!duration_s(spec) || all.contains(spec.name)) continue;
    Json targets = Json::array();
    for (int scan = 1; scan <= scan_count(spec); ++scan) {
      const std::vector<TargetState> states = states_at(spec, scan * spec.world.scan_period_s);
      for (std::size_t n = 0; n < states.size(); ++n) {
        targets[n].push_back({states[n].x, states[n].y});
      }
    }
    all[spec.name] = {{"scan_period_s", spec.world.scan_period_s}, {"targets", targets}};
  }
  return all;
}

}  // namespace mda
