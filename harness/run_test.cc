#include "harness/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "algorithms/catalog.h"
#include "harness/errors.h"
#include "harness/files.h"
#include "harness/testing/recorded_run.h"
#include "harness/testing/small_disk.h"
#include "harness/testing/temporary_directory.h"

namespace mda::testing {
namespace {

using nlohmann::json;

bool by_key(const json& a, const json& b) {
  return std::pair(window_of(a), a["algorithm"].get<std::string>()) <
         std::pair(window_of(b), b["algorithm"].get<std::string>());
}

class RunTest : public ::testing::Test {
 protected:
  /// The small sweep with one worker; run once per test program.
  static const RecordedRun& run() {
    static const RecordedRun kRun = recorded_run(small_sweep(), 1);
    return kRun;
  }
};

TEST_F(RunTest, TheManifestCountsTheRows) {
  const json& summary = run().manifest["summary"];
  EXPECT_EQ(run().manifest["outcome"], "finished");
  EXPECT_EQ(run().manifest["workers"], 1);
  EXPECT_EQ(run().manifest["sweep"]["seed"], 1);
  EXPECT_EQ(run().manifest["arguments"], json({"run", "small"}));
  EXPECT_TRUE(run().manifest["end"].is_string());
  EXPECT_EQ(summary["cells"], 3);
  EXPECT_EQ(summary["cells_finished"], 3);
  EXPECT_EQ(summary["cells_failed"], 0);
  EXPECT_EQ(summary["windows"], 90);
  EXPECT_EQ(summary["rows"], run().rows.size());
  EXPECT_EQ(summary["refuted"], 0);
  const auto skipped = std::count_if(run().rows.begin(), run().rows.end(),
                                     [](const json& row) { return row["status"] == "skipped"; });
  EXPECT_GT(skipped, 0) << "brute-force takes no large windows";
  EXPECT_EQ(summary["skipped"], skipped);
  const std::size_t of_the_reference = 90;  // nobody has asked for its rows
  EXPECT_EQ(run().answers.size(),
            run().rows.size() - static_cast<std::size_t>(skipped) + of_the_reference);
}

TEST_F(RunTest, RowsDoNotDependOnTheWorkers) {
  const auto erase_times = [](json& row) {
    for (const char* field : {"wall_ms", "cpu_ms", "translate_ms", "views_ms", "grow_ms", "lp_ms",
                              "round_ms", "workers"}) {
      row.erase(field);
    }
  };
  const auto without_times = [&](std::vector<json> lines) {
    std::sort(lines.begin(), lines.end(), by_key);
    for (json& line : lines) {
      erase_times(line);
      if (line.contains("row")) erase_times(line["row"]);
    }
    return lines;
  };
  const RecordedRun two = recorded_run(small_sweep(), 2);
  EXPECT_EQ(without_times(run().rows), without_times(two.rows));
  EXPECT_EQ(without_times(run().answers), without_times(two.answers));
  for (const json& row : two.rows) EXPECT_EQ(row["workers"], 2);
}

/// Every cell that has a row has all of them.
void expect_whole_cells(const std::vector<json>& rows, std::size_t rows_per_cell) {
  std::map<CellKey, std::size_t> count;
  for (const json& row : rows) ++count[cell_of(row)];
  for (const auto& [cell, n] : count) EXPECT_EQ(n, rows_per_cell);
}

Sweep long_sweep() {
  Sweep sweep = small_sweep();
  sweep.scenarios = {{scenario_named("A"), {3}, 100000}};
  sweep.driver = reference_algorithm().name;
  sweep.algorithms = {"greedy", sweep.driver};
  return sweep;
}

TEST_F(RunTest, AnInterruptedRunKeepsWholeCells) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "run";
  std::atomic<bool> interrupted = false;
  std::thread impatient([&] {
    const auto has_rows = [&] {
      std::error_code error;
      const auto size = std::filesystem::file_size(path / "rows.jsonl", error);
      return !error && size > 0;
    };
    while (!has_rows()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    interrupted = true;
  });
  const RunRecord record = run_sweep(long_sweep(), path, 2, {}, interrupted);
  impatient.join();
  EXPECT_EQ(record.outcome, "interrupted");
  EXPECT_GT(record.cells_finished, 0);
  EXPECT_LT(record.cells_finished, record.cells);
  const std::vector<json> rows = lines_of(path / "rows.jsonl");
  EXPECT_EQ(rows.size(), static_cast<std::size_t>(record.cells_finished) * 60);
  expect_whole_cells(rows, 60);
  const json manifest = json::parse(read_file((path / "manifest.json").string()));
  EXPECT_EQ(manifest["outcome"], "interrupted");
  EXPECT_EQ(manifest["summary"]["rows"], rows.size());
}

TEST_F(RunTest, ARunInterruptedBeforeItBeganHasNoRows) {
  const std::atomic<bool> interrupted = true;
  const RecordedRun run = recorded_run(small_sweep(), 2, interrupted);
  EXPECT_TRUE(run.rows.empty());
  EXPECT_EQ(run.manifest["outcome"], "interrupted");
}

TEST_F(RunTest, AFullDiskEndsTheRunAndKeepsWholeCells) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "run";
  const std::atomic<bool> interrupted = false;
  const SmallDisk disk(300000);
  EXPECT_THROW(run_sweep(long_sweep(), path, 2, {}, interrupted), DiskError);
  const std::vector<json> rows = lines_of(path / "rows.jsonl");
  EXPECT_GT(rows.size(), 0U);
  expect_whole_cells(rows, 60);
  expect_whole_cells(lines_of(path / "answers.jsonl"), 60);
  const json manifest = json::parse(read_file((path / "manifest.json").string()));
  EXPECT_EQ(manifest["outcome"], "disk failure");
  EXPECT_EQ(manifest["summary"]["rows"], rows.size());
}

TEST_F(RunTest, ADirectoryThatHoldsARunIsRefusedBeforeAnythingRuns) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = true;
  EXPECT_EQ(run_sweep(small_sweep(), directory.path(), 1, {}, interrupted).cells, 3);
  const std::string before = read_file(directory.file("manifest.json"));
  EXPECT_THROW(run_sweep(small_sweep(), directory.path(), 1, {}, interrupted), InputError);
  EXPECT_EQ(read_file(directory.file("manifest.json")), before);
}

}  // namespace
}  // namespace mda::testing
