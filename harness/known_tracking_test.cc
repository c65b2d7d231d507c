#include "harness/known_tracking.h"

#include <gtest/gtest.h>

#include <map>

#include "harness/run.h"
#include "harness/testing/recorded_run.h"
#include "harness/testing/temporary_directory.h"

namespace mda::testing {
namespace {

using nlohmann::json;

/// Scenario 2 with long scan periods: few scans, three targets.
Sweep short_study(const std::vector<std::string>& algorithms, bool closed_loop) {
  Sweep sweep;
  sweep.name = "short";
  sweep.driver = reference_algorithm().name;
  sweep.algorithms = algorithms;
  sweep.scenarios.push_back({.spec = scenario_named("battistelli-2"),
                             .windows = {1, 3},
                             .replicates = 2,
                             .scan_periods_s = {10.0},
                             .closed_loop = closed_loop});
  return sweep;
}

std::vector<json> tracking_of(const Sweep& sweep, int workers) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = false;
  static_cast<void>(run_sweep(sweep, directory.path() / "run", workers, {}, interrupted));
  return lines_of(directory.path() / "run" / "tracking.jsonl");
}

std::map<std::string, json> by_name(const std::vector<json>& lines) {
  std::map<std::string, json> result;
  for (json line : lines) {
    for (const char* time : {"wall_ms", "cpu_ms", "hypotheses_cpu_ms", "workers"}) line.erase(time);
    const std::string name = line["replicate"].dump() + " " + line["window_k"].dump() + " " +
                             line["algorithm"].get<std::string>();
    result.emplace(name, std::move(line));
  }
  return result;
}

TEST(KnownTrackingTest, LinesDoNotDependOnWorkersOrCompany) {
  const auto one = by_name(tracking_of(short_study({"scf-tie", "sd-exact", "greedy"}, true), 1));
  const auto two = by_name(tracking_of(short_study({"greedy", "scf-tie"}, true), 2));
  EXPECT_EQ(one.size(), 12U);
  for (const auto& [name, line] : two) EXPECT_EQ(one.at(name), line) << name;
}

TEST(KnownTrackingTest, MeansAreThoseOfTheSeries) {
  for (const json& line : tracking_of(short_study({"sd-exact", "scf", "gnn-by-scan"}, true), 2)) {
    SCOPED_TRACE(line.dump());
    ASSERT_EQ(line["status"], "finished");
    EXPECT_EQ(line["scans"], 35);
    EXPECT_EQ(line["targets"], 3);
    EXPECT_EQ(line["unanswered"], 0);
    const std::map<std::string, std::string> means = {
        {"position_error_m", "position_error_series_m"},
        {"ideal_error_m", "ideal_series_m"},
        {"oracle_error_m", "oracle_series_m"},
        {"right_share", "right_series"}};
    for (const auto& [mean, series] : means) {
      double sum = 0.0;
      ASSERT_EQ(line[series].size(), 35U);
      for (const json& value : line[series]) sum += value.get<double>();
      EXPECT_NEAR(sum / 35.0, line[mean].get<double>(), 0.011) << mean;
    }
    for (const char* share : {"right_share", "right_share_fixed", "lost_ever", "lost_at_end"}) {
      EXPECT_GE(line[share], 0.0);
      EXPECT_LE(line[share], 1.0);
    }
    EXPECT_LE(line["lost_at_end"], line["lost_ever"]);
  }
}

TEST(KnownTrackingTest, TwoOptimalSolversTrackAlike) {
  const auto lines = by_name(tracking_of(short_study({"sd-exact", "cbc"}, true), 2));
  for (const char* cell : {"1 1 ", "1 3 ", "2 1 ", "2 3 "}) {
    const json& a = lines.at(std::string(cell) + "sd-exact");
    const json& b = lines.at(std::string(cell) + "cbc");
    EXPECT_EQ(a["position_error_series_m"], b["position_error_series_m"]) << cell;
    EXPECT_EQ(a["right_share_fixed"], b["right_share_fixed"]) << cell;
  }
}

TEST(KnownTrackingTest, WithAWindowOfOneScanDecisionsAreFixedAtOnce) {
  for (const json& line : tracking_of(short_study({"sd-exact"}, true), 2)) {
    if (line["window_k"] != 1) continue;
    EXPECT_EQ(line["right_share"], line["right_share_fixed"]);
  }
}

TEST(KnownTrackingTest, WhatCannotDriveIsSkipped) {
  for (const json& line : tracking_of(short_study({"lp", "gnn"}, true), 1)) {
    const bool can = line["algorithm"] == "gnn" && line["window_k"] == 1;
    EXPECT_EQ(line["status"], can ? "finished" : "skipped") << line.dump();
    EXPECT_EQ(line.contains("position_error_m"), can);
    EXPECT_EQ(line["note"].get<std::string>().empty(), can);
  }
}

TEST(KnownWindowsInOpenLoop, SequencesBesideTheColumnsAreJudgedAndCounted) {
  Sweep sweep = short_study({"scf", "scf-tie", "mcf", "viterbi-sequential", "sd-exact"}, false);
  sweep.scenarios[0].spec = scenario_named("battistelli-1-dense");
  sweep.scenarios[0].windows = {4};
  int off_columns = 0;
  for (const json& row : recorded_run(sweep, 2).rows) {
    SCOPED_TRACE(row.dump());
    EXPECT_TRUE(row["status"] == "optimal" || row["status"] == "feasible");
    EXPECT_EQ(row["row_violation"], 0.0);
    EXPECT_TRUE(row["truth_cost_nats"].is_null());
    if (row["algorithm"] == "sd-exact") {
      EXPECT_EQ(row["gap_nats"], 0.0);
      EXPECT_TRUE(row["views_ms"].is_null());
      continue;
    }
    EXPECT_TRUE(row["views_ms"].is_number());
    EXPECT_GT(row["graph_arcs"].is_null() ? 1 : row["graph_arcs"].get<int>(), 0);
    const int off = row["off_column_paths"].get<int>();
    off_columns += off;
    if (off == 0) {
      EXPECT_GE(row["gap_nats"], -1e-6) << "no choice of columns is cheaper than the optimum";
    }
  }
  EXPECT_GT(off_columns, 0) << "the test shows nothing";
}

TEST(KnownWindowsInOpenLoop, OnlyEveryFewWindowsAreForTheAlgorithms) {
  Sweep all = short_study({"scf-tie"}, false);
  Sweep some = all;
  some.scenarios[0].every = 4;
  std::map<WindowKey, json> rows;
  for (const json& row : recorded_run(all, 2).rows) rows[window_of(row)] = row["cost_nats"];
  const RecordedRun run = recorded_run(some, 2);
  EXPECT_EQ(run.rows.size(), 4U * (35 / 4));
  for (const json& row : run.rows) {
    EXPECT_EQ(row["scan"].get<int>() % 4, 0);
    EXPECT_EQ(row["cost_nats"], rows.at(window_of(row)));
  }
}

}  // namespace
}  // namespace mda::testing
