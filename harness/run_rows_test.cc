// What the rows of a run say, and that it fits together.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "harness/referee.h"
#include "harness/testing/recorded_run.h"

namespace mda::testing {
namespace {

using nlohmann::json;

class RunRowsTest : public ::testing::Test {
 protected:
  /// The small sweep with one worker; run once per test program.
  static const RecordedRun& run() {
    static const RecordedRun kRun = recorded_run(small_sweep(), 1);
    return kRun;
  }
};

TEST_F(RunRowsTest, EveryRowHasTheContractsFieldsAndTypes) {
  const std::map<std::string, std::vector<const char*>> fields = {
      {"string",
       {"scenario", "driver", "fingerprint", "algorithm", "answer", "status", "stop", "note"}},
      {"integer",
       {"schema_version", "seed", "window_k", "replicate", "scan", "rows", "columns", "nonzeros",
        "dimensions", "components", "largest_component_columns", "workers"}},
      {"integer or null",
       {"fractional", "paper_fractional", "iterations", "nodes", "off_column_paths"}},
      {"number", {"scan_period_s", "grow_ms", "retired_nats"}},
      {"number or null",
       {"wall_ms", "cpu_ms", "translate_ms", "views_ms", "lp_ms", "round_ms", "cost_nats",
        "bound_nats", "certified_bound_nats", "reference_cost_nats", "truth_cost_nats", "gap_nats",
        "gap_share", "row_violation"}},
      {"boolean or null", {"integral", "tight"}}};
  const auto has_type = [](const json& value, const std::string& type) {
    if (type.ends_with("null") && value.is_null()) return true;
    if (type.starts_with("string")) return value.is_string();
    if (type.starts_with("integer")) return value.is_number_integer();
    if (type.starts_with("number")) return value.is_number();
    return value.is_boolean();
  };
  for (const json& row : run().rows) {
    for (const auto& [type, names] : fields) {
      for (const char* name : names) {
        ASSERT_TRUE(row.contains(name)) << name;
        ASSERT_TRUE(has_type(row[name], type)) << name << " = " << row[name] << " in " << row;
      }
    }
    EXPECT_EQ(row["fingerprint"].get<std::string>().size(), 16U);
  }
}

TEST_F(RunRowsTest, EveryWindowHasARowOfEveryAlgorithm) {
  std::map<WindowKey, std::set<std::string>> algorithms;
  std::map<WindowKey, std::set<std::string>> fingerprints;
  for (const json& row : run().rows) {
    EXPECT_TRUE(algorithms[window_of(row)].insert(row["algorithm"]).second) << "twice: " << row;
    fingerprints[window_of(row)].insert(row["fingerprint"]);
  }
  EXPECT_EQ(algorithms.size(), 3U * 30U);
  for (const auto& [window, names] : algorithms) EXPECT_EQ(names.size(), 6U);
  for (const auto& [window, names] : fingerprints) EXPECT_EQ(names.size(), 1U) << "one problem";
}

TEST_F(RunRowsTest, CostsGapsAndBoundsFitTogether) {
  for (const json& row : run().rows) {
    SCOPED_TRACE(row.dump());
    ASSERT_TRUE(row["reference_cost_nats"].is_number());
    if (row["status"] == "skipped") continue;
    const double reference = row["reference_cost_nats"];
    const double tolerance = cost_tolerance(reference);
    EXPECT_EQ(row["gap_nats"].is_number(), row["answer"] == "selection");
    EXPECT_EQ(row["gap_share"].is_number(), row["answer"] == "selection");
    EXPECT_LE(row["row_violation"].get<double>(), 1e-6);
    if (row["answer"] == "selection") {
      EXPECT_EQ(row["gap_nats"].get<double>(), row["cost_nats"].get<double>() - reference);
      EXPECT_GE(row["gap_nats"].get<double>(), -tolerance);
      const double share = reference < 0.0 ? row["gap_nats"].get<double>() / -reference : 0.0;
      EXPECT_NEAR(row["gap_share"].get<double>(), share, 1e-12);
    }
    if (row["algorithm"] == "exact" || row["algorithm"] == "cbc") {
      EXPECT_EQ(row["status"], "optimal");
      EXPECT_NEAR(row["gap_nats"].get<double>(), 0.0, tolerance);
    }
    for (const char* bound : {"bound_nats", "certified_bound_nats"}) {
      if (row[bound].is_null()) continue;
      EXPECT_LE(row[bound].get<double>(), reference + tolerance);
    }
  }
}

TEST_F(RunRowsTest, IntegralityIsThatOfTheRelaxation) {
  std::map<WindowKey, const json*> relaxation;
  for (const json& row : run().rows) {
    if (row["algorithm"] == "lp") relaxation[window_of(row)] = &row;
  }
  int fractional = 0;
  for (const json& row : run().rows) {
    SCOPED_TRACE(row.dump());
    if (row["algorithm"] == "greedy") {
      EXPECT_EQ(row["integral"].is_null(), row["columns"] != 0) << "it has no relaxation";
    }
    if (row["algorithm"] != "lp" && row["algorithm"] != "lp-grp") continue;
    EXPECT_EQ(row["integral"].get<bool>(), row["fractional"] == 0);
    EXPECT_GE(row["paper_fractional"], row["fractional"]);
    EXPECT_TRUE(row["tight"] || !row["integral"]);
    if (row["algorithm"] == "lp-grp") {
      EXPECT_EQ(row["fractional"], (*relaxation.at(window_of(row)))["fractional"]);
      EXPECT_TRUE(!row["integral"] || std::abs(row["gap_nats"].get<double>()) < 1e-5);
      fractional += row["integral"] ? 0 : 1;
    }
  }
  EXPECT_GT(fractional, 0) << "the sweep is too easy to tell";
}

TEST_F(RunRowsTest, WindowsWithoutColumnsAreIntegralAndCostNothing) {
  int seen = 0;
  for (const json& row : run().rows) {
    if (row["columns"] != 0) continue;
    ++seen;
    SCOPED_TRACE(row.dump());
    EXPECT_EQ(row["integral"], true);
    EXPECT_EQ(row["tight"], true);
    EXPECT_EQ(row["fractional"], 0);
    EXPECT_EQ(row["cost_nats"], 0.0);
    EXPECT_EQ(row["components"], 0);
    if (row["answer"] == "selection") {
      EXPECT_EQ(row["gap_nats"], 0.0);
      EXPECT_EQ(row["gap_share"], 0.0);
    }
  }
  EXPECT_GT(seen, 0);
}

TEST_F(RunRowsTest, WindowsOfDifferentKComeFromTheSamePlots) {
  std::map<int, std::map<int, std::string>> fingerprint;  // [K][scan]
  std::map<int, std::map<int, double>> truth;
  for (const json& row : run().rows) {
    if (row["scenario"] != "A") continue;
    fingerprint[row["window_k"]][row["scan"]] = row["fingerprint"];
    truth[row["window_k"]][row["scan"]] = row["truth_cost_nats"];
  }
  // Up to N = K + 1 a window holds all scans, so K cannot matter yet.
  for (int scan = 1; scan <= 4; ++scan) EXPECT_EQ(fingerprint[3][scan], fingerprint[5][scan]);
  EXPECT_NE(fingerprint[3], fingerprint[5]);
  EXPECT_EQ(truth[3], truth[5]);
}

TEST_F(RunRowsTest, ScenesDependOnSeedAndReplicateOnly) {
  const auto fingerprints = [](Sweep sweep, std::uint64_t seed, int replicates) {
    sweep.scenarios = {{scenario_named("A"), {3}, replicates}};
    sweep.seed = seed;
    sweep.algorithms = {"greedy"};
    std::map<int, std::vector<std::string>> result;
    for (const json& row : recorded_run(sweep, 1).rows) {
      result[row["replicate"]].push_back(row["fingerprint"]);
    }
    return result;
  };
  const auto three = fingerprints(small_sweep(), 1, 3);
  EXPECT_EQ(three.at(1), fingerprints(small_sweep(), 1, 1).at(1));
  EXPECT_NE(three.at(1), three.at(2));
  EXPECT_NE(three.at(1), fingerprints(small_sweep(), 2, 1).at(1));
}

TEST_F(RunRowsTest, TheDriverNeedsNoRowAndAdvancesTheWindows) {
  const auto driven_by = [](const char* driver) {
    Sweep sweep = small_sweep();
    sweep.scenarios = {{scenario_named("D"), {2}, 1}};
    sweep.algorithms = {"lp"};
    sweep.driver = driver;
    const RecordedRun run = recorded_run(sweep, 1);
    EXPECT_EQ(run.rows.size(), 30U);
    std::set<std::string> fingerprints;
    for (const json& row : run.rows) {
      EXPECT_EQ(row["driver"], driver);
      EXPECT_EQ(row["algorithm"], "lp");
      fingerprints.insert(row["fingerprint"]);
    }
    return fingerprints;
  };
  EXPECT_NE(driven_by("greedy"), driven_by("exact")) << "other answers lead to other windows";
  EXPECT_EQ(driven_by("cbc"), driven_by("exact")) << "the same answers to the same";
}

}  // namespace
}  // namespace mda::testing
