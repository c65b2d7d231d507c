#include "harness/closed_loop.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "harness/files.h"
#include "harness/run.h"
#include "harness/testing/recorded_run.h"
#include "harness/testing/temporary_directory.h"

namespace mda::testing {
namespace {

using nlohmann::json;

std::vector<json> tracking_of(const Sweep& sweep, int workers) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = false;
  static_cast<void>(run_sweep(sweep, directory.path() / "run", workers, {}, interrupted));
  return lines_of(directory.path() / "run" / "tracking.jsonl");
}

Sweep closed_sweep(const std::vector<std::string>& algorithms) {
  Sweep sweep = small_sweep();
  sweep.algorithms = algorithms;
  for (ScenarioPlan& plan : sweep.scenarios) plan.closed_loop = true;
  return sweep;
}

/// The line of an algorithm in one cell, without its times.
std::map<std::string, json> by_name(const std::vector<json>& lines) {
  std::map<std::string, json> result;
  for (json line : lines) {
    for (const char* time : {"wall_ms", "cpu_ms", "workers"}) line.erase(time);
    const std::string name = line["scenario"].get<std::string>() + line["window_k"].dump() +
                             line["algorithm"].get<std::string>();
    result.emplace(name, std::move(line));
  }
  return result;
}

TEST(ClosedLoopTest, LinesDoNotDependOnWorkersOrCompany) {
  const auto one = by_name(tracking_of(closed_sweep({"lp-grp", "exact", "greedy"}), 1));
  const auto two = by_name(tracking_of(closed_sweep({"greedy", "exact"}), 2));
  EXPECT_EQ(one.size(), 9U);
  for (const auto& [name, line] : two) EXPECT_EQ(one.at(name), line) << name;
}

TEST(ClosedLoopTest, SharesAndPartsAreWhatTheySay) {
  for (const json& line : tracking_of(closed_sweep({"exact", "greedy"}), 2)) {
    SCOPED_TRACE(line.dump());
    EXPECT_EQ(line["status"], "finished");
    EXPECT_EQ(line["scans"], 30);
    EXPECT_EQ(line["unanswered"], 0);
    for (const char* share : {"correct_association", "purity", "completeness"}) {
      EXPECT_GE(line[share], 0.0);
      EXPECT_LE(line[share], 1.0);
    }
    // The mean of squares is at least the square of the mean.
    const double parts = line["gospa_localisation_km2"].get<double>() +
                         line["gospa_missed_km2"].get<double>() +
                         line["gospa_false_km2"].get<double>();
    EXPECT_GE(parts, std::pow(line["gospa_km"].get<double>(), 2) - 1e-9);
    EXPECT_LE(line["ospa_km"], kTrackingCutOffKm);
    EXPECT_LE(line["lost"], line["present"]);
    EXPECT_GT(line["tracks"], 0);
  }
}

TEST(ClosedLoopTest, TheDriversOwnLoopEndsAtTheOpenLoopsCost) {
  const RecordedRun open = recorded_run(small_sweep(), 2);
  for (const json& line : tracking_of(closed_sweep({"exact"}), 2)) {
    for (const json& row : open.rows) {
      if (row["algorithm"] != "exact" || row["scan"] != 30 || cell_of(row) != cell_of(line)) {
        continue;
      }
      const double o = row["retired_nats"].get<double>() + row["cost_nats"].get<double>();
      EXPECT_NEAR(line["cost_nats"].get<double>(), o, 1e-9);
      EXPECT_NEAR(line["truth_cost_nats"].get<double>(), row["truth_cost_nats"].get<double>(),
                  1e-9);
    }
  }
}

TEST(ClosedLoopTest, WhatCannotDriveIsSkippedOrCounted) {
  for (const json& line : tracking_of(closed_sweep({"lp", "brute-force"}), 1)) {
    if (line["algorithm"] == "lp") {
      EXPECT_EQ(line["status"], "skipped");
      EXPECT_FALSE(line.contains("gospa_km"));
    } else {
      EXPECT_GT(line["unanswered"], 0) << "brute-force declines large windows";
      EXPECT_NE(line["note"], "");
    }
  }
}

TEST(ClosedLoopTest, WhoDeclinesEveryWindowIsSkipped) {
  for (const json& line : tracking_of(closed_sweep({"mapada"}), 1)) {
    EXPECT_EQ(line["status"], "skipped");
    EXPECT_NE(line["note"], "");
    EXPECT_FALSE(line.contains("gospa_km"));
  }
}

}  // namespace
}  // namespace mda::testing
