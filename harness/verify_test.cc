#include "harness/verify.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "harness/errors.h"
#include "harness/files.h"
#include "harness/run.h"
#include "harness/testing/recorded_run.h"
#include "harness/testing/tampered_run.h"

namespace mda::testing {
namespace {

using nlohmann::json;

class VerifyTest : public TamperedRun {
 protected:
  VerifyTest() : TamperedRun(original()) {}

 private:
  static const std::filesystem::path& original() {
    static const std::filesystem::path kPath = kept_run(small_sweep());
    return kPath;
  }
};

bool is_row(const json& row, const char* algorithm, int scan) {
  return row["algorithm"] == algorithm && row["scan"] == scan;
}

TEST_F(VerifyTest, AnHonestRunAgreesWhateverTheWorkers) {
  for (const int workers : {1, 3}) {
    const Verification result = verify(workers);
    EXPECT_EQ(result.disagreements, 0) << (result.examples.empty() ? "" : result.examples.front());
    EXPECT_EQ(result.windows, 90);
    EXPECT_EQ(result.rows, 90 * 6);
  }
}

TEST_F(VerifyTest, EveryClaimOfARowIsChecked) {
  for (const char* field : {"cost_nats", "gap_nats", "certified_bound_nats", "retired_nats",
                            "truth_cost_nats", "fractional", "integral", "columns", "status"}) {
    SCOPED_TRACE(field);
    tamper("rows.jsonl", [&](json& row) {
      if (!is_row(row, "lp-grp", 20)) return false;
      json& value = row[field];
      if (value.is_boolean()) {
        value = !value.get<bool>();
      } else if (value.is_string()) {
        value = value == "optimal" ? "feasible" : "optimal";
      } else {
        value = value.get<double>() + 1.0;
      }
      return true;
    });
    expect_disagreement(field);
    restore();
  }
}

TEST_F(VerifyTest, AnotherAnswerIsNoticed) {
  tamper("answers.jsonl", [](json& answer) {
    if (!is_row(answer, "greedy", 20) || answer["columns"].empty()) return false;
    answer["columns"].erase(0);
    return true;
  });
  expect_disagreement("cost_nats");
}

TEST_F(VerifyTest, AColumnThatIsListedTwiceIsNoticed) {
  tamper("answers.jsonl", [](json& answer) {
    if (!is_row(answer, "exact", 20) || answer["columns"].empty()) return false;
    answer["columns"].push_back(answer["columns"][0]);
    return true;
  });
  expect_disagreement("names a column twice");
}

TEST_F(VerifyTest, AnotherWayOfEndingIsNoticed) {
  tamper("rows.jsonl", [](json& row) {
    if (!is_row(row, "greedy", 20)) return false;
    row["stop"] = "deadline";
    return true;
  });
  expect_disagreement("'stop'");
}

TEST_F(VerifyTest, ABrokenAnswerIsNoticed) {
  tamper("answers.jsonl", [](json& answer) {
    if (!is_row(answer, "exact", 20)) return false;
    answer["columns"] = {0, 1, 2, 3, 4, 5, 6, 7};
    return true;
  });
  EXPECT_GT(verify().disagreements, 0);
}

TEST_F(VerifyTest, MultipliersThatCertifyLessAreNoticed) {
  tamper("answers.jsonl", [](json& answer) {
    if (!is_row(answer, "lp", 20) || answer["row_dual"].empty()) return false;
    answer["row_dual"][0] = answer["row_dual"][0].get<double>() + 100.0;
    return true;
  });
  expect_disagreement("certified_bound_nats");
}

TEST_F(VerifyTest, OfARunInBothLoopsTheOpenOneIsChecked) {
  const TemporaryDirectory directory;
  Sweep sweep = small_sweep();
  sweep.scenarios.resize(1);
  sweep.scenarios.push_back(sweep.scenarios[0]);
  sweep.scenarios[1].closed_loop = true;
  sweep.scenarios[1].algorithms = {"greedy"};
  const std::atomic<bool> interrupted = false;
  static_cast<void>(run_sweep(sweep, directory.path() / "run", 2, {}, interrupted));
  EXPECT_FALSE(lines_of(directory.path() / "run" / "tracking.jsonl").empty());
  const RunFiles files(directory.path() / "run");
  const Verification result = verify_run(files, 2, interrupted);
  EXPECT_EQ(result.disagreements, 0);
  EXPECT_EQ(result.rows, std::ssize(lines_of(directory.path() / "run" / "rows.jsonl")));
}

TEST_F(VerifyTest, ScenesAreMadeAnew) {
  EXPECT_EQ(verify().scenes, 3);
  const auto tampered = [&](const std::function<void(json&)>& change) {
    tamper("scenes.jsonl", [&](json& scene) {
      change(scene);
      return true;
    });
    expect_disagreement("of scenes.jsonl comes out differently");
    restore();
  };
  tampered([](json& scene) { scene["plots"][9][0][2] = scene["plots"][9][0][2] == -1 ? 0 : -1; });
  tampered([](json& scene) { scene["targets"][0]["positions_km"][0][1] = 77.0; });
  tampered([](json& scene) { scene["answers"][0]["scans"][9]["tracks"][0].push_back(-1); });
  tampered([](json& scene) { scene["answers"].erase(0); });
  tamper("scenes.jsonl", [](json& scene) {
    scene = nullptr;
    return true;
  });
  expect_disagreement("scenes.jsonl has 0 lines of it");
}

TEST_F(VerifyTest, RunsOfOlderProgramsHaveNoScenes) {
  std::filesystem::remove(path() / "scenes.jsonl");
  const Verification result = verify();
  EXPECT_EQ(result.disagreements, 0);
  EXPECT_EQ(result.scenes, 0);
}

TEST_F(VerifyTest, AMissingRowIsNoticed) {
  tamper("rows.jsonl", [](json& row) {
    if (!is_row(row, "cbc", 12)) return false;
    row = nullptr;
    return true;
  });
  expect_disagreement("its row is missing");
}

TEST_F(VerifyTest, OtherWindowsAreNoticed) {
  change_manifest("\"gate\": 9.21", "\"gate\": 12.0");
  expect_disagreement("fingerprint");
}

TEST_F(VerifyTest, OfAKilledRunWhatIsWholeIsChecked) {
  constexpr int kRowsOfACell = 30 * 6;
  const std::string file = (path() / "rows.jsonl").string();
  const std::string rows = read_file(file);
  change_manifest("\"outcome\": \"finished\"", "\"outcome\": \"running\"");
  write_file(file, rows.substr(0, rows.size() - 20));
  EXPECT_EQ(RunFiles(path()).torn().size(), 1U);
  Verification result = verify();
  EXPECT_EQ(result.disagreements, 0) << result.examples.front();
  EXPECT_EQ(result.rows, 3 * kRowsOfACell - 6) << "all but the last window's";
  // Answers are written first: of the last cell there may be nothing else.
  std::size_t end = rows.size();
  for (int line = 0; line <= kRowsOfACell; ++line) end = rows.rfind('\n', end - 1);
  write_file(file, rows.substr(0, end + 1));
  const std::string answers = read_file((path() / "answers.jsonl").string());
  write_file((path() / "answers.jsonl").string(), answers.substr(0, answers.size() - 20));
  result = verify();
  EXPECT_EQ(result.disagreements, 0) << result.examples.front();
  EXPECT_EQ(result.rows, 2 * kRowsOfACell);
}

TEST_F(VerifyTest, AFinishedRunMayLackNoRow) {
  const std::string rows = read_file((path() / "rows.jsonl").string());
  write_file((path() / "rows.jsonl").string(), rows.substr(0, rows.size() - 20));
  EXPECT_EQ(RunFiles(path()).torn().size(), 1U);
  expect_disagreement("its row is missing");
}

TEST_F(VerifyTest, ALineThatIsTornBeforeTheLastIsRefused) {
  const std::string rows = read_file((path() / "rows.jsonl").string());
  write_file((path() / "rows.jsonl").string(), rows.substr(1));
  EXPECT_THROW(RunFiles{path()}, InputError);
}

TEST_F(VerifyTest, WhatIsNoRunIsRefused) {
  for (const char* text : {"", "{}", "[1]", "{\"schema_version\": 99}", "\x01\x02"}) {
    write_file((path() / "manifest.json").string(), text);
    EXPECT_THROW(RunFiles{path()}, InputError) << text;
  }
  std::filesystem::remove(path() / "manifest.json");
  EXPECT_THROW(RunFiles{path()}, InputError);
}

}  // namespace
}  // namespace mda::testing
