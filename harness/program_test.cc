// The program as its users meet it: exit codes, what it prints, what it leaves on the disk.
// MDA_BENCH is its path.
#include "harness/testing/program_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "algorithms/catalog.h"
#include "harness/errors.h"
#include "harness/files.h"
#include "harness/testing/recorded_run.h"

namespace mda::testing {
namespace {

using nlohmann::json;

TEST_F(ProgramTest, HelpIsThereForEveryCommand) {
  for (const Words& words :
       {Words{"--help"}, Words{"list", "--help"}, Words{"run", "--help"}, Words{"export", "--help"},
        Words{"solve", "--help"}, Words{"flow", "--help"}, Words{"doctor", "--help"}}) {
    const Outcome outcome = bench(words);
    EXPECT_EQ(outcome.code, kWell);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("Usage: mda-bench"), std::string::npos) << outcome.out;
  }
  EXPECT_EQ(bench({"--version"}).code, kWell);
}

TEST_F(ProgramTest, ListsAreTextOrJson) {
  for (const char* what : {"algorithms", "scenarios", "sweeps"}) {
    const Outcome text = bench({"list", what});
    EXPECT_EQ(text.code, kWell);
    const Outcome machine = bench({"list", what, "--json"});
    EXPECT_EQ(machine.code, kWell);
    for (const json& item : json::parse(machine.out)) {
      EXPECT_NE(text.out.find(item["name"].get<std::string>()), std::string::npos);
    }
  }
}

TEST_F(ProgramTest, DoctorSaysTheSameInWordsJsonAndExitCode) {
  const Outcome machine = bench({"doctor", "--json"});
  const json state = json::parse(machine.out);
  EXPECT_EQ(machine.code, state["fit"].get<bool>() ? kWell : kUnfitForTiming);
  const Outcome words = bench({"doctor"});
  for (const json& finding : state["findings"]) {
    EXPECT_NE(words.out.find(finding["what"].get<std::string>()), std::string::npos);
    EXPECT_EQ(finding["good"].get<bool>(), finding["change"].is_null());
  }
}

TEST_F(ProgramTest, BadInputOfEveryKindIsRefused) {
  std::ofstream(file("broken.toml")) << "name = [";
  std::ofstream(file("bytes.toml")) << std::string("\x9f\0\xc3\x28\n\x01", 6);
  std::ofstream(file("bytes.json")) << std::string("\x9f\0\xc3\x28\n\x01", 6);
  std::ofstream(file("broken.json")) << "{\"schema\": 1, \"rows\": [";
  std::ofstream(file("good.json")) << "{\"schema\": 1, \"rows\": [], \"columns\": []}";
  std::ofstream(file("file")) << "mine";
  std::ofstream(file("good.min")) << "p min 2 1\nn 1 0\nn 2 0\na 1 2 -1\n";
  std::ofstream(file("broken.min")) << "p min 2 1\nn 1 0\nn 2 0\na 1 2 nan\n";
  std::ofstream(file("empty.min")) << "";
  std::ofstream(file("ragged.txt")) << "2\n4 1\n3\n7 2\n5 6\n";
  std::ofstream(file("axial.txt")) << "2\n4 1\n3 9\n7 2\n5 6\n";
  std::ofstream(file("two.toml")) << "name = \"two\"\nscenarios = [\"static3-36-s0.20-f0.1\"]\n"
                                     "windows = [3]\nalgorithms = [\"bojilov\"]\n"
                                     "[world]\nsensors = 2\n";
  for (const char* name : {"folder", "folder.toml", "folder.json"}) {
    std::filesystem::create_directory(file(name));
  }
  std::filesystem::create_directory(file("old"));
  std::ofstream(file("old/rows.jsonl")) << "";
  const Words exported = {"export", "A", "--scan", "9", "--window", "3", "--format", "json"};
  const auto with = [](Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const std::vector<Words> cases = {
      {},
      {"run", "nonsense"},
      {"run", "two\nlines"},
      {"run", "two\nlines.toml"},
      {"run", "absent.toml"},
      {"run", "folder.toml"},
      {"run", "broken.toml"},
      {"run", "bytes.toml"},
      {"run", "two.toml"},
      {"run", "bojilov1995", "--windows", "2"},
      {"solve", "--format", "axial3", "ragged.txt", "--algorithm", "exact"},
      {"solve", "--format", "axial3", "absent.txt", "--algorithm", "exact"},
      {"solve", "--format", "axial3", "good.json", "--algorithm", "exact"},
      {"solve", "--format", "axial3", "axial.txt", "--algorithm", "bojilov"},
      {"solve", "--format", "axial2", "axial.txt", "--algorithm", "exact"},
      {"solve", "axial.txt", "--algorithm", "exact"},
      {"run", "smoke", "--algorithms", "nonsense"},
      {"run", "smoke", "--algorithms", ""},
      {"run", "smoke", "--algorithms", "exact,"},
      {"run", "smoke", "--algorithms=exact,,greedy"},
      {"run", "smoke", "--scenarios", "Z"},
      {"run", "smoke", "--windows", "0"},
      {"run", "smoke", "--windows", "31"},
      {"run", "smoke", "--windows", "3,3"},
      {"run", "smoke", "--seed", "-1"},
      {"run", "smoke", "--out", "/proc/nowhere"},
      {"run", "smoke", "--out", "file"},
      {"run", "smoke", "--out", "file/below"},
      {"run", "smoke", "--out", "old"},
      {"run", "smoke", "--out", "new/newer/" + std::string(300, 'a')},
      {"export", "Z", "--scan", "9", "--window", "3", "--format", "json"},
      {"export", "A", "--scan", "0", "--window", "3", "--format", "json"},
      {"export", "A", "--scan", "31", "--window", "3", "--format", "json"},
      {"export", "A", "--scan", "9", "--window", "0", "--format", "json"},
      {"export", "A", "--scan", "9", "--window", "-1", "--format", "json"},
      {"export", "A", "--scan", "9", "--window", "3", "--format", "xls"},
      {"export", "A", "--scan", "1", "--window", "3", "--format", "mps"},
      {"export", "A", "--scan", "1", "--window", "3", "--format", "lp"},
      with(exported, {"--out", "/proc/nowhere"}),
      with(exported, {"--out", "absent/w.json"}),
      with(exported, {"--out", "folder"}),
      {"solve", "absent.json", "--algorithm", "exact"},
      {"solve", "folder.json", "--algorithm", "exact"},
      {"solve", "broken.json", "--algorithm", "exact"},
      {"solve", "bytes.json", "--algorithm", "exact"},
      {"solve", "/dev/zero", "--algorithm", "exact"},
      {"solve", "good.json", "--algorithm", "nonsense"},
      {"solve", "good.json", "--algorithm", "exact", "--time-limit", "nan"},
      {"flow"},
      {"flow", "good.min"},
      {"flow", "good.min", "--algorithm", "nonsense"},
      {"flow", "good.min", "--algorithm", "exact"},
      {"flow", "absent.min", "--algorithm", "scf-networksimplex"},
      {"flow", "folder", "--algorithm", "scf-networksimplex"},
      {"flow", "broken.min", "--algorithm", "scf-networksimplex"},
      {"flow", "empty.min", "--algorithm", "scf-networksimplex", "--json"},
      {"flow", "bytes.json", "--algorithm", "scf-networksimplex"},
  };
  for (const Words& words : cases) expect_refused(words);
}

TEST_F(ProgramTest, AnExportedWindowSolvesToWhatTheRunSaid) {
  ASSERT_EQ(bench({"run", "smoke", "--scenarios", "B", "--windows", "3", "--algorithms", "exact",
                   "--out", "run"})
                .code,
            kWell);
  for (const json& row : lines_of(file("run/rows.jsonl"))) {
    if (row["scan"] != 30) continue;
    ASSERT_EQ(bench({"export", "B", "--scan", "30", "--window", "3", "--format", "json", "--out",
                     "w.json"})
                  .code,
              kWell);
    for (const char* algorithm : {"exact", "cbc", "lp"}) {
      const Outcome outcome = bench({"solve", "w.json", "--algorithm", algorithm, "--json"});
      ASSERT_EQ(outcome.code, kWell) << outcome.err;
      const json solved = json::parse(outcome.out);
      EXPECT_EQ(solved["fingerprint"], row["fingerprint"]);
      EXPECT_EQ(solved["status"], "optimal");
      for (const char* name : {"cost_nats", "bound_nats", "seconds"}) {
        EXPECT_TRUE(solved[name].is_number()) << name;
      }
      const double cost = row["cost_nats"];
      ASSERT_TRUE(solved.contains("certified_bound_nats"));
      EXPECT_TRUE(solved["certified_bound_nats"].is_null() ||
                  solved["certified_bound_nats"].get<double>() <= cost);
      if (algorithm != std::string("lp")) {
        EXPECT_NEAR(solved["cost_nats"].get<double>(), cost, 1e-5);
      }
    }
  }
}

/// Of 40 s: 40 scans at the scene's own period of 1 s, 80 at half of that.
TEST_F(ProgramTest, ExportKnowsTheScansOfAScene) {
  const auto words = [](const char* scan) {
    return Words{"export", "lee-ten", "--scan", scan, "--window", "1", "--format", "json"};
  };
  const auto with_period = [](Words all) {
    all.insert(all.end(), {"--scan-period", "0.5"});
    return all;
  };
  EXPECT_EQ(bench(words("40")).code, kWell);
  expect_refused(words("41"));
  EXPECT_EQ(bench(with_period(words("80"))).code, kWell);
  expect_refused(with_period(words("81")));
  EXPECT_NE(json::parse(bench(words("40")).out)["columns"],
            json::parse(bench(words("39")).out)["columns"]);
}

TEST_F(ProgramTest, MarginalsAreShownWithTheirValues) {
  ASSERT_EQ(bench({"export", "lee-ten", "--scan", "20", "--window", "1", "--format", "json",
                   "--out", "w.json"})
                .code,
            kWell);
  const json window = json::parse(read_file(file("w.json")));
  const json solved = json::parse(bench({"solve", "w.json", "--algorithm", "jpda", "--json"}).out);
  ASSERT_EQ(solved["values"].size(), solved["columns"].size());
  std::vector<double> sums(window["rows"].size(), 0.0);
  for (std::size_t i = 0; i < solved["columns"].size(); ++i) {
    for (const json& row : window["columns"][solved["columns"][i].get<std::size_t>()]["rows"]) {
      sums[row.get<std::size_t>()] += solved["values"][i].get<double>();
    }
  }
  for (std::size_t r = 0; r < sums.size(); ++r) {
    if (window["rows"][r]["use"] == "exactly-once") {
      EXPECT_NEAR(sums[r], 1.0, 1e-5);  // columns of hardly any probability are not listed
    }
    EXPECT_LE(sums[r], 1.0 + 1e-9);
  }
  const json chosen = json::parse(bench({"solve", "w.json", "--algorithm", "gnn", "--json"}).out);
  EXPECT_TRUE(chosen["values"].empty());
}

TEST_F(ProgramTest, DenseAxialFilesAreSolved) {
  std::ofstream(file("axial.txt")) << "2\n4 1\n3 9\n7 2\n5 6\n";
  for (const char* name : {"exact", "cbc", "lagrangian-sd"}) {
    const Outcome outcome =
        bench({"solve", "--format", "axial3", "axial.txt", "--algorithm", name, "--json"});
    EXPECT_EQ(outcome.code, kWell) << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(result["cost_nats"], 5.0) << name;
    EXPECT_EQ(result["columns"], (json{2, 5})) << name;
    EXPECT_NEAR(result["bound_nats"].get<double>(), 5.0, 1e-6) << name;
  }
}

TEST_F(ProgramTest, WhoCannotSolveDeclinesWithAReason) {
  ASSERT_EQ(
      bench({"export", "C", "--scan", "20", "--window", "3", "--format", "json", "--out", "w.json"})
          .code,
      kWell);
  expect_refused({"solve", "w.json", "--algorithm", "brute-force"});
  expect_refused({"solve", "w.json", "--algorithm", "exact", "--certificate", "p.json"});
  expect_refused({"solve", "w.json", "--algorithm", "tree-exact", "--certificate", "w.json"});
  expect_refused({"solve", "w.json", "--algorithm", "tree-exact", "--certificate", ""});
}

TEST_F(ProgramTest, ACertificateIsWrittenOrTheAnswerAlone) {
  ASSERT_EQ(
      bench({"export", "C", "--scan", "20", "--window", "3", "--format", "json", "--out", "w.json"})
          .code,
      kWell);
  Words words = {"solve",         "w.json", "--algorithm", "tree-exact",
                 "--certificate", "p.json", "--json"};
  const Outcome solved = bench(words);
  EXPECT_EQ(solved.code, kWell) << solved.err;
  EXPECT_EQ(json::parse(bench({"certify", "w.json", "p.json", "--json"}).out)["cost_nats"],
            json::parse(solved.out)["cost_nats"]);
  std::filesystem::remove(file("p.json"));
  words.insert(words.end(), {"--time-limit", "1e-9"});
  const Outcome cut_short = bench(words);
  EXPECT_EQ(cut_short.code, kCellsFailed);
  EXPECT_EQ(json::parse(cut_short.out)["stop"], "deadline");
  EXPECT_NE(cut_short.err.find("p.json: not written"), std::string::npos) << cut_short.err;
  EXPECT_FALSE(std::filesystem::exists(file("p.json")));
}

TEST_F(ProgramTest, FullAndClosedOutputsAreTold) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  ASSERT_EQ(
      bench({"export", "C", "--scan", "20", "--window", "7", "--format", "json", "--out", "w.json"})
          .code,
      kWell);
  const std::vector<Words> talkers = {
      {"list", "algorithms"},
      {"--help"},
      {"solve", "w.json", "--algorithm", "greedy"},
      {"export", "C", "--scan", "20", "--window", "7", "--format", "json"}};
  for (const Words& words : talkers) {
    for (const char* out : {"/dev/full", ""}) {
      EXPECT_EQ(program_.run(words, {out, file("err")}), kDiskFailed) << words[0] << " > " << out;
      const std::string err = read_file(file("err"));
      EXPECT_TRUE(err.starts_with("mda-bench: cannot write to standard output")) << err;
      EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
    }
  }
}

}  // namespace
}  // namespace mda::testing
