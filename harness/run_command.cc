#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "harness/commands.h"
#include "harness/errors.h"
#include "harness/run.h"

namespace mda {
namespace {

/// Made for this run alone: another one of the same second has another name. If it cannot be made,
/// who uses the name will find out why.
std::string default_directory(const Sweep& sweep) {
  const std::filesystem::path parent = "results/runs";
  std::string time = utc_now();
  std::erase_if(time, [](char c) { return c == '-' || c == ':'; });
  const std::string name = (parent / fmt::format("{}-{}", sweep.name, time)).string();
  std::error_code error;
  std::filesystem::create_directories(parent, error);
  std::string free = name;
  for (int number = 2; !std::filesystem::create_directory(free, error) && !error; ++number) {
    free = fmt::format("{}-{}", name, number);
  }
  return free;
}

void print_summary(const RunRecord& record, const std::string& directory) {
  const Tally& t = record.tally;
  fmt::print("{} of {} cells, {} windows, {} rows in {:.1f} s with {} workers (speed-up {:.2f})\n",
             record.cells_finished, record.cells, t.windows, t.rows, record.parallel_ms / 1e3,
             record.workers, speed_up(record));
  fmt::print(
      "of {:.1f} s of CPU time: {:.1f} s solving, {:.1f} s hypotheses, {:.1f} s simulation, "
      "{:.1f} % other\n",
      t.cell_cpu_ms / 1e3, t.solve_cpu_ms / 1e3, t.hypotheses_cpu_ms / 1e3, t.simulate_cpu_ms / 1e3,
      100.0 * other_share(record));
  if (t.compared > 0) {
    fmt::print(
        "{} windows were proven optimal by two or more algorithms: {} (largest difference {:.1e} "
        "nats)\n",
        t.compared, t.largest_exact_spread <= 1e-5 ? "all agree within 1e-5" : "THEY DISAGREE",
        t.largest_exact_spread);
  }
  fmt::print("rows: {} refuted, {} failed, {} stopped by the time limit, {} skipped\n", t.refuted,
             t.failed, t.timed_out, t.skipped);
  if (record.cells_failed > 0) {
    fmt::print("cells: {} failed and have no rows; stderr says why\n", record.cells_failed);
  }
  if (!t.worst_example.empty()) fmt::print("first of them: {}\n", t.worst_example);
  if (t.fallbacks > 0) {
    fmt::print("{} windows had to be advanced without the driver's answer\n", t.fallbacks);
  }
  fmt::print("the run is in {}\n", directory);
}

/// Runs in a directory of that name; one that was made here and is still empty goes away again if
/// the run cannot begin.
RunRecord run_in(const std::string& directory, const Sweep& sweep, const RunCommand& command,
                 const std::atomic<bool>& interrupted) {
  try {
    return run_sweep(sweep, directory, worker_count(command.workers), command.arguments,
                     interrupted);
  } catch (const std::exception&) {
    std::error_code ignored;
    if (command.out.empty()) std::filesystem::remove(directory, ignored);
    throw;
  }
}

int exit_code(const RunRecord& record) {
  if (record.tally.refuted > 0) return kWrongAnswer;
  if (record.outcome == "interrupted") return kInterrupted;
  return record.tally.failed + record.cells_failed > 0 ? kCellsFailed : kWell;
}

}  // namespace

int run(const RunCommand& command, const std::atomic<bool>& interrupted) {
  const Sweep sweep = changed(load_sweep(command.sweep), command.changes);
  const std::string directory = command.out.empty() ? default_directory(sweep) : command.out;
  const RunRecord record = run_in(directory, sweep, command, interrupted);
  if (command.json) {
    fmt::print("{}\n", manifest(sweep, record)["summary"].dump(2));
  } else {
    print_summary(record, directory);
  }
  return exit_code(record);
}

}  // namespace mda
