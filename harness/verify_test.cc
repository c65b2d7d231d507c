#include "harness/verify.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <sstream>

#include "harness/errors.h"
#include "harness/files.h"
#include "harness/run.h"
#include "harness/testing/recorded_run.h"
#include "harness/testing/temporary_directory.h"

namespace mda::testing {
namespace {

using nlohmann::json;

/// A recorded run that may be tampered with; every test has a copy of its own.
class VerifyTest : public ::testing::Test {
 protected:
  VerifyTest() { restore(); }

  /// Undoes all tampering.
  void restore() const {
    std::filesystem::remove_all(path());
    std::filesystem::copy(original(), path(), std::filesystem::copy_options::recursive);
  }

  [[nodiscard]] std::filesystem::path path() const { return directory_.path() / "run"; }

  [[nodiscard]] Verification verify(int workers = 2) const {
    const std::atomic<bool> interrupted = false;
    return verify_run(RunFiles(path()), workers, interrupted);
  }

  /// Changes one line of a file, as JSON; the first for which `change` returns true.
  void tamper(const std::string& name, const std::function<bool(json&)>& change) {
    std::istringstream text(read_file((path() / name).string()));
    std::string tampered;
    bool done = false;
    for (std::string line; std::getline(text, line);) {
      json object = json::parse(line);
      if (!done && change(object)) {
        done = true;
        line = object.is_null() ? "" : object.dump();
      }
      if (!line.empty()) tampered += line + "\n";
    }
    ASSERT_TRUE(done);
    write_file((path() / name).string(), tampered);
  }

  /// The sentence of the only disagreement expected.
  void expect_disagreement(const std::string& with) const {
    const Verification result = verify();
    ASSERT_GT(result.disagreements, 0);
    EXPECT_NE(result.examples.front().find(with), std::string::npos) << result.examples.front();
  }

 private:
  static const std::filesystem::path& original() {
    static const TemporaryDirectory kDirectory;
    static const std::filesystem::path kPath = [] {
      const std::atomic<bool> interrupted = false;
      auto made = kDirectory.path() / "run";
      static_cast<void>(run_sweep(small_sweep(), made, 2, {}, interrupted));
      return made;
    }();
    return kPath;
  }

  TemporaryDirectory directory_;
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

TEST_F(VerifyTest, AMissingRowIsNoticed) {
  tamper("rows.jsonl", [](json& row) {
    if (!is_row(row, "cbc", 12)) return false;
    row = nullptr;
    return true;
  });
  expect_disagreement("its row is missing");
}

TEST_F(VerifyTest, OtherWindowsAreNoticed) {
  std::string manifest = read_file((path() / "manifest.json").string());
  const auto place = manifest.find("\"gate\": 9.21");
  ASSERT_NE(place, std::string::npos);
  manifest.replace(place, 12, "\"gate\": 12.0");
  write_file((path() / "manifest.json").string(), manifest);
  expect_disagreement("fingerprint");
}

TEST_F(VerifyTest, ATornFileIsRefused) {
  const std::string rows = read_file((path() / "rows.jsonl").string());
  write_file((path() / "rows.jsonl").string(), rows.substr(0, rows.size() - 20));
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
