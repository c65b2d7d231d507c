// Three sensors at one instant, from the scenario to the rows.
#include "harness/sensor_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <vector>

#include "harness/judge.h"
#include "harness/run.h"
#include "harness/run_files.h"
#include "harness/testing/recorded_run.h"
#include "harness/testing/temporary_directory.h"
#include "harness/verify.h"
#include "scenarios/static3/sensor_points.h"
#include "scenarios/static3/sensor_window.h"

namespace mda::testing {
namespace {

using nlohmann::json;

constexpr std::uint64_t kSeed = 1;

ScenarioSpec some_point() { return sensor_point(36, SensorLayout::kGrid, 0.25, 0.1); }

double optimum(const AssociationProblem& problem) {
  const Solution solution = reference_algorithm().make()->solve(problem, Budget{});
  EXPECT_EQ(solution.status, Status::kOptimal);
  return examine(problem, solution.x).cost;
}

TEST(SensorLoopTest, PermutedSensorsHaveTheSameOptimum) {
  for (int replicate = 1; replicate <= 20; ++replicate) {
    SensorScene scene = simulate_sensors(some_point(), kSeed, replicate);
    const double cost = optimum(sensor_window(some_point(), scene).problem);
    for (const std::size_t sensor : {1, 2}) {
      std::swap(scene.reports[sensor], scene.reports[sensor - 1]);
      EXPECT_NEAR(optimum(sensor_window(some_point(), scene).problem), cost, 1e-9);
    }
  }
}

TEST(SensorLoopTest, OneWindowPerSceneAndTheTruthIsRight) {
  SensorLoop loop;
  for (int replicate = 1; replicate <= 5; ++replicate) {
    loop.start(some_point(), kSeed, replicate, 3, true);
    ASSERT_TRUE(loop.next());
    EXPECT_EQ(loop.scan(), 1);
    Solution truth;
    truth.x.assign(static_cast<std::size_t>(loop.window().problem.columns()), 0.0);
    for (const auto& rows : true_tuples(simulate_sensors(some_point(), kSeed, replicate))) {
      Tuple& tuple = truth.tuples.emplace_back();
      tuple.rows.assign(3, kNoRow);
      for (const int row : rows) {
        tuple.rows[static_cast<std::size_t>(loop.window().problem.dimension(row) - 1)] = row;
      }
    }
    const Examination examined = examine(loop.window().problem, truth.x, truth.tuples);
    EXPECT_TRUE(examined.is_choice());
    EXPECT_NEAR(examined.cost, *loop.truth_cost(), 1e-9);
    const AssociationCounts counts = *loop.association(truth);
    EXPECT_EQ(counts.target_exact(), 1.0);
    EXPECT_EQ(counts.pair_precision(), 1.0);
    EXPECT_EQ(counts.pair_recall(), 1.0);
    loop.advance({});
    EXPECT_FALSE(loop.next());
  }
}

Sweep sensor_sweep() {
  Sweep sweep;
  sweep.name = "sensors";
  sweep.scenarios = {{.spec = some_point(), .windows = {3}, .replicates = 3},
                     {.spec = some_point(),
                      .windows = {3},
                      .replicates = 6,
                      .algorithms = {"bojilov", "greedy"},
                      .first_replicate = 4}};
  sweep.driver = "exact";
  sweep.algorithms = {"bojilov",
                      "bojilov-untreated",
                      "bojilov-calibrated",
                      "exact",
                      "cbc",
                      "lp-grp",
                      "lagrangian-sd",
                      "greedy",
                      "lp",
                      "gnn"};
  return sweep;
}

TEST(SensorLoopTest, RowsTellHowWellAnAnswerAgreesWithTheTruth) {
  const RecordedRun run = recorded_run(sensor_sweep(), 1);
  EXPECT_EQ(run.rows.size(), 3U * 10U + 3U * 2U);
  EXPECT_EQ(run.record.tally.failed + run.record.tally.refuted, 0)
      << run.record.tally.worst_example;
  std::map<int, double> bound;
  std::map<int, double> cost;
  for (const json& row : run.rows) {
    SCOPED_TRACE(row.dump());
    const bool chooses = row["answer"] == "selection" && row["status"] != "skipped";
    for (const char* field : {"target_exact", "pair_precision", "pair_recall"}) {
      ASSERT_EQ(row[field].is_number(), chooses);
    }
    EXPECT_EQ(row["dimensions"], 3);
    EXPECT_EQ(row["scan"], 1);
    if (!chooses) continue;
    EXPECT_NEAR(row["target_exact"].get<double>(),
                row["exact_tuples"].get<double>() / row["true_tuples"].get<double>(), 1e-12);
    EXPECT_LE(row["exact_tuples"].get<int>(), row["answer_tuples"].get<int>());
    EXPECT_LE(row["right_pairs"].get<int>(), row["answer_pairs"].get<int>());
    EXPECT_LE(row["right_pairs"].get<int>(), row["true_pairs"].get<int>());
    EXPECT_GE(row["target_exact"].get<double>(), 0.2);
    const int replicate = row["replicate"];
    if (row["algorithm"] == "lagrangian-sd") {
      bound[replicate] = row["certified_bound_nats"];
      cost[replicate] = row["cost_nats"];
    }
  }
  for (const json& row : run.rows) {
    if (row["algorithm"] != "exact") continue;
    EXPECT_LE(bound.at(row["replicate"]), row["cost_nats"].get<double>() + 1e-6);
    EXPECT_GE(cost.at(row["replicate"]), row["cost_nats"].get<double>() - 1e-6);
  }
}

TEST(SensorLoopTest, OtherScenariosHaveNoSuchFields) {
  Sweep sweep = small_sweep();
  sweep.scenarios.resize(1);
  sweep.algorithms = {"greedy", "bojilov"};
  const RecordedRun run = recorded_run(sweep, 1);
  for (const json& row : run.rows) {
    EXPECT_FALSE(row.contains("target_exact"));
    EXPECT_EQ(row["status"] == "skipped", row["algorithm"] == "bojilov");
  }
}

TEST(SensorLoopTest, ARunIsVerifiedWithItsParts) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = false;
  const auto path = directory.path() / "run";
  static_cast<void>(run_sweep(sensor_sweep(), path, 2, {"run"}, interrupted));
  const Verification result = verify_run(RunFiles(path), 1, interrupted);
  EXPECT_EQ(result.rows, 36);
  EXPECT_EQ(result.windows, 6);
  EXPECT_EQ(result.disagreements, 0) << result.examples.front();
}

}  // namespace
}  // namespace mda::testing
