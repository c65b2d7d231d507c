#include "harness/position_tracking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "harness/run.h"
#include "harness/testing/recorded_run.h"
#include "harness/testing/temporary_directory.h"
#include "harness/verify.h"

namespace mda::testing {
namespace {

using nlohmann::json;

Sweep study(const std::vector<std::string>& scenarios, const std::vector<std::string>& algorithms,
            int replicates, bool closed_loop = true) {
  Sweep sweep;
  sweep.name = "single scans";
  sweep.driver = reference_algorithm().name;
  sweep.algorithms = algorithms;
  sweep.scan_periods_s = {1.0};
  for (const std::string& name : scenarios) {
    sweep.scenarios.push_back({.spec = scenario_named(name),
                               .windows = {1},
                               .replicates = replicates,
                               .closed_loop = closed_loop});
  }
  return sweep;
}

std::vector<json> tracking_of(const Sweep& sweep, int workers = 2) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = false;
  static_cast<void>(run_sweep(sweep, directory.path() / "run", workers, {}, interrupted));
  return lines_of(directory.path() / "run" / "tracking.jsonl");
}

/// One replicate of the sweep's first scenario, its first algorithm played by `solver`.
json line_of(const Sweep& sweep, std::unique_ptr<Associator> solver) {
  Worker worker;
  const ScenarioPlan& plan = sweep.scenarios[0];
  worker.players(sweep, plan)[0].solver = std::move(solver);
  const std::atomic<bool> interrupted = false;
  const CellReport report = run_position_cell({&plan, 1.0, 1, 1}, sweep, worker, 1, interrupted);
  std::istringstream lines(report.tracking);
  std::string text;
  std::getline(lines, text);  // the oracle's
  std::getline(lines, text);
  return json::parse(text);
}

std::map<std::string, json> by_name(const std::vector<json>& lines) {
  std::map<std::string, json> result;
  for (json line : lines) {
    for (const char* time : {"wall_ms", "cpu_ms", "hypotheses_cpu_ms", "workers"}) line.erase(time);
    const std::string name = line["scenario"].get<std::string>() + " " + line["replicate"].dump() +
                             " " + line["algorithm"].get<std::string>();
    result.emplace(name, std::move(line));
  }
  return result;
}

/// Every track for itself: what a column's likelihood ratio has in the sum of its track's.
class Independent final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override { return {.answer = Answer::kMarginals}; }
  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget&) override {
    Solution solution;
    solution.status = Status::kFeasible;
    solution.answer = Answer::kMarginals;
    std::vector<double> sums(static_cast<std::size_t>(problem.rows()), 0.0);
    for (int j = 0; j < problem.columns(); ++j) {
      solution.x.push_back(std::exp(-problem.cost(j)));
      sums[static_cast<std::size_t>(problem.rows_of(j)[0])] += solution.x.back();
    }
    for (int j = 0; j < problem.columns(); ++j) {
      solution.x[static_cast<std::size_t>(j)] /=
          sums[static_cast<std::size_t>(problem.rows_of(j)[0])];
    }
    solution.stats.iterations = 3;
    return solution;
  }
};

/// The reference's choice, handed over as marginals.
class ChoiceAsMarginals final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override { return {.answer = Answer::kMarginals}; }
  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    Solution solution = reference_algorithm().make()->solve(problem, budget);
    solution.answer = Answer::kMarginals;
    solution.status = Status::kFeasible;
    return solution;
  }
};

TEST(PositionTrackingTest, LinesDoNotDependOnWorkersOrCompany) {
  const std::vector<std::string> scenes = {"lee-crossing-c0.8", "lee-ten"};
  const auto one = by_name(tracking_of(study(scenes, {"gnn", "nn", "greedy"}, 2), 1));
  const auto two = by_name(tracking_of(study(scenes, {"greedy", "gnn"}, 2), 2));
  EXPECT_EQ(one.size(), 16U);
  EXPECT_EQ(two.size(), 12U);
  for (const auto& [name, line] : two) EXPECT_EQ(one.at(name), line) << name;
}

TEST(PositionTrackingTest, TheTruthMaintainsNearlyEverything) {
  double tracks = 0.0;
  double kept = 0.0;
  for (const json& line :
       tracking_of(study({"lee-crossing", "lee-parallel-c0.8", "lee-ten"}, {"nn"}, 10))) {
    ASSERT_EQ(line["status"], "finished");
    if (line["algorithm"] != kOracle) continue;
    EXPECT_EQ(line["swaps"], 0);
    EXPECT_EQ(line["coalescences"], 0);
    for (std::size_t i = 0; i < line["targets"].size(); ++i) {
      EXPECT_FALSE(line["dropped"][i]);
      EXPECT_TRUE(line["maintained_750m"][i]);
      tracks += 1.0;
      kept += line["maintained_450m"][i] ? 1.0 : 0.0;
    }
  }
  EXPECT_EQ(tracks, 140.0);
  EXPECT_GE(kept / tracks, 0.97);
}

/// What a line says of a target follows from its series.
TEST(PositionTrackingTest, SumsAndLossesAreThoseOfTheSeries) {
  int lost = 0;
  for (const json& line : tracking_of(study({"lee-parallel-c0.8", "lee-ten"}, {"gnn", "nn"}, 3))) {
    const std::size_t targets = line["scenario"] == "lee-ten" ? 10 : 2;
    ASSERT_EQ(line["targets"].size(), targets);
    EXPECT_EQ(line["targets"][0], targets == 10 ? 1 : 3);
    for (std::size_t i = 0; i < targets; ++i) {
      const auto errors = line["position_error_series_km"][i].get<std::vector<double>>();
      const auto speeds = line["velocity_error_series_km_s"][i].get<std::vector<double>>();
      ASSERT_EQ(errors.size(), 40U);
      ASSERT_EQ(line["track_series_km"][i].size(), 40U);
      double squares = 0.0;
      double speed_squares = 0.0;
      double last = 0.0;
      for (std::size_t scan = 0; scan < 40; ++scan) {
        squares += errors[scan] * errors[scan];
        speed_squares += speeds[scan] * speeds[scan];
        if (scan >= 35) last = std::max(last, errors[scan]);
      }
      EXPECT_NEAR(line["position_squares_km2"][i], squares, 1e-4 * (40.0 + squares));
      EXPECT_NEAR(line["velocity_squares_km2_s2"][i], speed_squares, 1e-4 * (40.0 + speed_squares));
      if (std::abs(last - 0.45) > 1e-4 && !line["dropped"][i]) {
        EXPECT_EQ(line["maintained_450m"][i], last < 0.45);
      }
      EXPECT_FALSE(line["dropped"][i] && line["maintained_750m"][i]);
      EXPECT_LE(line["maintained_450m"][i], line["maintained_750m"][i]);
      lost += line["maintained_750m"][i] ? 0 : 1;
    }
  }
  EXPECT_GT(lost, 0) << "no track was lost in dense clutter";
}

TEST(PositionTrackingTest, TwoOptimalSolversTrackAlike) {
  const auto lines = by_name(tracking_of(study({"lee-ten-uniform"}, {"gnn", "cbc"}, 2)));
  for (const char* run : {"lee-ten-uniform 1 ", "lee-ten-uniform 2 "}) {
    EXPECT_EQ(lines.at(std::string(run) + "gnn")["track_series_km"],
              lines.at(std::string(run) + "cbc")["track_series_km"]);
  }
}

TEST(PositionTrackingTest, CertainMarginalsAreAChoice) {
  for (const TrackUpdate update : {TrackUpdate::kSoft, TrackUpdate::kHard}) {
    Sweep sweep = study({"lee-ten"}, {"gnn"}, 1);
    sweep.scenarios[0].spec.model.update = update;
    const json line = line_of(sweep, std::make_unique<ChoiceAsMarginals>());
    EXPECT_EQ(line["status"], "finished") << line["note"];
    EXPECT_EQ(line["track_series_km"],
              line_of(sweep, find_algorithm("gnn")->make())["track_series_km"]);
    EXPECT_EQ(line["conflict_rate"], 0.0);
    EXPECT_EQ(line["update"], update == TrackUpdate::kSoft ? "soft" : "hard");
  }
}

TEST(PositionTrackingTest, MarginalsMoveTracksSoftlyOrHard) {
  Sweep sweep = study({"lee-parallel-c0.8"}, {"gnn"}, 1);
  const json soft = line_of(sweep, std::make_unique<Independent>());
  sweep.scenarios[0].spec.model.update = TrackUpdate::kHard;
  const json hard = line_of(sweep, std::make_unique<Independent>());
  for (const json& line : {soft, hard}) {
    EXPECT_EQ(line["status"], "finished") << line["note"];
    EXPECT_EQ(line["unanswered"], 0);
    EXPECT_EQ(line["iterations_per_scan"], 3.0);
    EXPECT_GT(line["conflict_rate"], 0.0) << "tracks for themselves never met";
  }
  EXPECT_NE(soft["track_series_km"], hard["track_series_km"]);
}

TEST(PositionTrackingTest, ChoicesNeverConflict) {
  for (const json& line : tracking_of(study({"lee-parallel-uniform-c0.8"}, {"gnn", "nn"}, 3))) {
    EXPECT_EQ(line["conflict_rate"], 0.0);
  }
}

TEST(PositionTrackingTest, RelaxationsAreFollowedAndWhatDeclinesIsSkipped) {
  for (const json& line : tracking_of(study({"lee-parallel"}, {"lp", "scf-pairs"}, 1))) {
    const bool skipped = line["algorithm"] == "scf-pairs";
    EXPECT_EQ(line["status"], skipped ? "skipped" : "finished");
    EXPECT_EQ(line["note"].get<std::string>().empty(), !skipped);
    EXPECT_EQ(line.contains("position_squares_km2"), !skipped);
  }
}

TEST(PositionTrackingTest, ABrokenCovarianceIsAFailedLine) {
  Sweep sweep = study({"lee-crossing"}, {"gnn"}, 1);
  sweep.scenarios[0].spec.position_targets->plot_sigma_km = 0.0;
  sweep.scenarios[0].spec.world.acceleration_sigma_km_s2 = 0.0;
  const std::vector<json> lines = tracking_of(sweep);
  ASSERT_EQ(lines.size(), 2U);
  for (const json& line : lines) {
    EXPECT_EQ(line["status"], "failed");
    EXPECT_NE(line["note"].get<std::string>().find("singular"), std::string::npos);
    EXPECT_FALSE(line.contains("track_series_km"));
  }
}

TEST(PositionWindowsInOpenLoop, ARunIsVerifiedAndHasAllWindows) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = false;
  const auto path = directory.path() / "run";
  const Sweep sweep =
      study({"lee-crossing-c0.8", "lee-ten-uniform"}, {"gnn", "nn", "exact", "lp"}, 2, false);
  const RunRecord record = run_sweep(sweep, path, 2, {}, interrupted);
  EXPECT_EQ(record.tally.windows, 2 * 2 * 40);
  EXPECT_EQ(record.tally.refuted + record.tally.failed + record.tally.skipped, 0);
  for (const json& row : lines_of(path / "rows.jsonl")) {
    EXPECT_EQ(row["dimensions"], 2);
    if (row["algorithm"] == "gnn" || row["algorithm"] == "exact") {
      EXPECT_NEAR(row["gap_nats"], 0.0, 1e-6);
    }
    EXPECT_TRUE(row["integral"].is_null() || row["integral"]) << "an assignment's only vertices";
  }
  const Verification verified = verify_run(RunFiles(path), 2, interrupted);
  EXPECT_EQ(verified.rows, 2 * 2 * 40 * 4);
  EXPECT_EQ(verified.disagreements, 0)
      << (verified.examples.empty() ? "" : verified.examples.front());
}

TEST(PositionWindowsInOpenLoop, ABrokenCovarianceFailsTheCellOnly) {
  Sweep sweep = study({"lee-crossing", "lee-parallel"}, {"gnn"}, 1, false);
  sweep.scenarios[0].spec.position_targets->plot_sigma_km = 0.0;
  sweep.scenarios[0].spec.world.acceleration_sigma_km_s2 = 0.0;
  const RecordedRun run = recorded_run(sweep, 2);
  EXPECT_EQ(run.record.cells_failed, 1);
  EXPECT_EQ(run.rows.size(), 40U);
}

}  // namespace
}  // namespace mda::testing
