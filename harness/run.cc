#include "harness/run.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <thread>

#include "harness/clocks.h"
#include "harness/closed_loop.h"
#include "harness/errors.h"
#include "harness/known_tracking.h"
#include "harness/messages.h"
#include "harness/plan.h"
#include "harness/position_tracking.h"
#include "harness/progress.h"
#include "harness/record.h"

namespace mda {
namespace {

/// What the workers share. Every member function may be called from any worker.
class Run {
 public:
  Run(const std::filesystem::path& directory, Contents contents, RunRecord& record, int cells)
      : directory_(directory, contents), record_(record), progress_(cells) {}

  /// What is there before the first cell. Throws DiskError, and then leaves nothing behind.
  void begin(const Sweep& sweep) {
    try {
      write_manifest(sweep);
      write_trajectories(sweep);
    } catch (const DiskError&) {
      directory_.discard();
      throw;
    }
  }
  void write_manifest(const Sweep& sweep) {
    directory_.write_manifest(manifest(sweep, record_).dump(2) + "\n");
  }

  [[nodiscard]] bool disk_failed() const { return disk_failed_; }
  [[nodiscard]] const std::string& disk_failure() const { return disk_failure_; }

  void finish(const CellReport& report) {
    const std::lock_guard lock(mutex_);
    if (disk_failed_) return;
    try {
      directory_.append({.rows = report.rows,
                         .answers = report.answers,
                         .tracking = report.tracking,
                         .scenes = report.scene});
    } catch (const DiskError& error) {
      disk_failure_ = error.what();
      disk_failed_ = true;
      return;
    }
    ++record_.cells_finished;
    record_.tally.add(report.tally);
    progress_.step(record_.tally.windows, record_.tally.rows);
  }

  void fail(const Cell& cell, const std::string& reason) {
    const std::lock_guard lock(mutex_);
    ++record_.cells_failed;
    record_.open_loop_cells_failed += cell.plan->closed_loop ? 0 : 1;
    tell(fmt::format("\nthe cell {} replicate {}, T = {} s, K = {} failed: {}\n",
                     cell.plan->spec.name, cell.replicate, cell.scan_period_s, cell.window_k,
                     one_line(reason)));
  }

 private:
  void write_trajectories(const Sweep& sweep) {
    const auto known = trajectories(sweep);
    if (!known.empty()) directory_.write_trajectories(known.dump() + "\n");
  }

  std::mutex mutex_;
  RunDirectory directory_;
  RunRecord& record_;
  Progress progress_;
  std::atomic<bool> disk_failed_ = false;
  std::string disk_failure_;
};

auto work_of(const ScenarioPlan& plan) {
  if (!plan.closed_loop) return run_cell;
  if (plan.spec.known_targets) return run_known_cell;
  return plan.spec.position_targets ? run_position_cell : run_closed_cell;
}

void work_on(const Cell& cell, const Sweep& sweep, Worker& worker, int workers,
             const std::atomic<bool>& interrupted, Run& run) {
  if (interrupted || run.disk_failed()) return;
  try {
    const CellReport report = work_of(*cell.plan)(cell, sweep, worker, workers, interrupted);
    if (report.finished) run.finish(report);
  } catch (const std::exception& error) {
    run.fail(cell, plain_words(error));
  }
}

Contents contents_of(const Sweep& sweep) {
  Contents contents{.open = false};
  for (const ScenarioPlan& plan : sweep.scenarios) {
    (plan.closed_loop ? contents.closed : contents.open) = true;
    if (records_scenes(plan)) contents.scenes = true;
  }
  return contents;
}

}  // namespace

int worker_count(int asked) {
  return asked > 0 ? asked : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

RunRecord run_sweep(const Sweep& sweep, const std::filesystem::path& directory, int workers,
                    const std::vector<std::string>& arguments,
                    const std::atomic<bool>& interrupted) {
  const std::vector<Cell> cells = plan(sweep);
  RunRecord record;
  record.arguments = arguments;
  record.workers = workers;
  record.cells = static_cast<int>(cells.size());
  record.start = utc_now();
  Run run(directory, contents_of(sweep), record, record.cells);
  run.begin(sweep);

  const Stopwatch watch;
#pragma omp parallel num_threads(workers)
  {
    Worker worker;
#pragma omp for schedule(dynamic, 1)
    for (std::size_t i = 0; i < cells.size(); ++i) {
      work_on(cells[i], sweep, worker, workers, interrupted, run);
    }
  }
  record.parallel_ms = watch.wall_ms();
  record.end = utc_now();
  record.outcome = run.disk_failed() ? "disk failure" : interrupted ? "interrupted" : "finished";
  if (run.disk_failed()) {
    try {
      run.write_manifest(sweep);
    } catch (const DiskError&) {  // it may or may not have room for that; the first failure is told
    }
    throw DiskError(run.disk_failure());
  }
  run.write_manifest(sweep);
  return record;
}

}  // namespace mda
