// Runs that something happens to. MDA_BENCH is the path of the program.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/errors.h"
#include "harness/files.h"
#include "harness/testing/bench_program.h"
#include "harness/testing/recorded_run.h"

namespace mda::testing {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

constexpr std::size_t kRowsPerCell = 2 * 30;

class ProgramRunsTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string file(const std::string& name) const { return program_.file(name); }

  /// A run that takes minutes, in the directory "run".
  static Words long_run() {
    return {"run",          "storms2003",        "--scenarios", "A", "--replicates", "100000",
            "--algorithms", "tree-exact,greedy", "--workers",   "2", "--out",        "run"};
  }

  [[nodiscard]] json manifest() const { return json::parse(read_file(file("run/manifest.json"))); }

  BenchProgram program_{MDA_BENCH};
};

TEST_F(ProgramRunsTest, CtrlCKeepsTheFinishedCells) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto process = program_.start(long_run(), {file("out"), file("err")});
    ASSERT_TRUE(program_.wait_for_text("run/rows.jsonl"));
    process->send(signal);
    EXPECT_EQ(process->wait(), kInterrupted);
    EXPECT_NE(read_file(file("err")).find("a second Ctrl-C stops at once"), std::string::npos);
    std::map<CellKey, std::size_t> rows;
    for (const json& row : lines_of(file("run/rows.jsonl"))) ++rows[cell_of(row)];
    EXPECT_FALSE(rows.empty());
    for (const auto& [cell, count] : rows) EXPECT_EQ(count, kRowsPerCell);
    EXPECT_EQ(manifest()["outcome"], "interrupted");
    EXPECT_EQ(manifest()["summary"]["cells_finished"], rows.size());
    EXPECT_EQ(lines_of(file("run/answers.jsonl")).size(), rows.size() * kRowsPerCell);
    std::filesystem::remove_all(file("run"));
  }
}

TEST_F(ProgramRunsTest, AKilledRunLeavesWholeLines) {
  const auto process = program_.start(long_run(), {});
  ASSERT_TRUE(program_.wait_for_text("run/rows.jsonl"));
  process->send(SIGKILL);
  EXPECT_EQ(process->wait(), 128 + SIGKILL);
  // Lines of a cell may lack, as the kill may cut a write short, and the last one its end.
  std::string rows = read_file(file("run/rows.jsonl"));
  rows.resize(rows.rfind('\n') + 1);
  std::ofstream(file("whole")) << rows;
  EXPECT_FALSE(lines_of(file("whole")).empty());
  EXPECT_EQ(manifest()["outcome"], "running");
}

TEST_F(ProgramRunsTest, NobodyNeedsToHearTheProgress) {
  const Words run = {"run", "smoke", "--scenarios", "A", "--algorithms", "tree-exact", "--out"};
  for (const char* err : {"/dev/full", ""}) {
    const std::string name = std::string("run") + (*err == '\0' ? "1" : "2");
    Words words = run;
    words.push_back(name);
    EXPECT_EQ(program_.run(words, {"/dev/null", err}), kWell) << err;
    EXPECT_EQ(lines_of(file(name + "/rows.jsonl")).size(), 60U) << "rows and nothing else";
    EXPECT_EQ(lines_of(file(name + "/answers.jsonl")).size(), 60U);
  }
}

TEST_F(ProgramRunsTest, AReaderThatGoesAwayEndsTheProgramQuietly) {
  const std::string line =
      "\"$0\" export C --scan 20 --window 7 --format json | head -n 0; "
      "echo ${PIPESTATUS[0]}";
  const Outcome outcome = run_program({"bash", "-c", line, MDA_BENCH}, ".");
  EXPECT_TRUE(outcome.out == "141\n" || outcome.out == "0\n") << outcome.out;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(ProgramRunsTest, ASecondSignalStopsAtOnce) {
  const auto process = program_.start(long_run(), {file("out"), file("err")});
  ASSERT_TRUE(program_.wait_for_text("run/rows.jsonl"));
  process->send(SIGSTOP);  // so that both are there before it goes on
  process->send(SIGINT);
  process->send(SIGTERM);
  process->send(SIGCONT);
  EXPECT_EQ(process->wait(), kInterrupted);
  EXPECT_EQ(manifest()["outcome"], "running") << "it had no time to say anything else";
  EXPECT_NE(read_file(file("err")).find("a second Ctrl-C stops at once"), std::string::npos);
  EXPECT_GT(read_file(file("run/rows.jsonl")).size(), 0U);
}

TEST_F(ProgramRunsTest, ALogThatIsClosedEndsNoRun) {
  const std::string line =
      "\"$0\" run smoke --scenarios A --algorithms exact --out run 2> >(exec true); echo $?";
  const Outcome outcome = run_program({"bash", "-c", line, MDA_BENCH}, file("."));
  EXPECT_TRUE(outcome.out.ends_with("\n0\n")) << outcome.out;
  EXPECT_EQ(lines_of(file("run/rows.jsonl")).size(), 60U);
  EXPECT_EQ(manifest()["outcome"], "finished");
}

TEST_F(ProgramRunsTest, APipeIsNoSweepFile) {
  ASSERT_EQ(mkfifo(file("pipe.toml").c_str(), 0600), 0);
  const Outcome outcome = program_.run({"run", "pipe.toml"});
  EXPECT_EQ(outcome.code, kBadInput);
  EXPECT_EQ(outcome.err, "mda-bench: cannot read 'pipe.toml': it is a pipe, not a file\n");
}

TEST_F(ProgramRunsTest, RunsOfOneSecondHaveDirectoriesOfTheirOwn) {
  const std::string line =
      "for i in 1 2 3 4; do \"$0\" run smoke --scenarios A --windows 3 --algorithms greedy & done; "
      "wait; ls results/runs | wc -l";
  const Outcome outcome = run_program({"bash", "-c", line, MDA_BENCH}, file("."));
  EXPECT_TRUE(outcome.out.ends_with("\n4\n")) << outcome.out << outcome.err;
}

TEST_F(ProgramRunsTest, ADiskThatIsFullAtTheStartLeavesNothing) {
  for (const char* out : {"--out new/run", ""}) {
    const std::string line = std::string("ulimit -f 0; exec \"$0\" run smoke ") + out;
    const Outcome outcome = run_program({"bash", "-c", line, MDA_BENCH}, file("."));
    EXPECT_EQ(outcome.code, kDiskFailed) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(file("new")));
    const std::string runs = file("results/runs");
    EXPECT_TRUE(!std::filesystem::exists(runs) || std::filesystem::is_empty(runs));
  }
}

TEST_F(ProgramRunsTest, ADiskThatFillsUpIsExitCodeFive) {
  const std::string line =
      "ulimit -f 100; exec \"$0\" run storms2003 "
      "--scenarios A --algorithms greedy --out run";
  const Outcome outcome = run_program({"bash", "-c", line, MDA_BENCH}, file("."));
  EXPECT_EQ(outcome.code, kDiskFailed) << outcome.err;
  EXPECT_NE(outcome.err.find("mda-bench: cannot write"), std::string::npos) << outcome.err;
  EXPECT_GT(lines_of(file("run/rows.jsonl")).size(), 0U);
  EXPECT_EQ(lines_of(file("run/rows.jsonl")).size() % 30, 0U) << "whole cells";
}

}  // namespace
}  // namespace mda::testing
