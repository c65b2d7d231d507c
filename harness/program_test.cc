// The program as its users meet it: exit codes, what it prints, what it leaves on the disk.
// MDA_BENCH is its path.
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
#include "harness/testing/bench_program.h"
#include "harness/testing/recorded_run.h"

namespace mda::testing {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

class ProgramTest : public ::testing::Test {
 protected:
  [[nodiscard]] Outcome bench(const Words& words) const { return program_.run(words); }
  [[nodiscard]] std::string file(const std::string& name) const { return program_.file(name); }

  /// Exit code 2, nothing on stdout, one line on stderr, and no file that was not there.
  void expect_refused(const Words& words) const {
    const auto files = listing();
    const Outcome outcome = bench(words);
    std::string shown;
    for (const std::string& word : words) shown += word + " ";
    EXPECT_EQ(outcome.code, kBadInput) << shown;
    EXPECT_EQ(outcome.out, "") << shown;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err << shown;
    EXPECT_TRUE(outcome.err.starts_with("mda-bench: ")) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with("\n")) << outcome.err;
    EXPECT_EQ(listing(), files) << shown;
  }

  BenchProgram program_{MDA_BENCH};

 private:
  [[nodiscard]] std::vector<std::string> listing() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(file("."))) {
      names.push_back(entry.path().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
};

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
}

TEST_F(ProgramTest, FlowsAreFoundByEveryCode) {
  std::ofstream(file("g.min")) << "c two ways\r\np min 4 4\r\nn 3 0\r\nn 1 0\r\n"
                                  "a 3 2 5\r\na 2 4 -9.5\r\na 4 1 1\r\na 2 1 -6\r\n";
  for (const FlowCode& code : flow_codes()) {
    const Words words = {"flow", "g.min", "--algorithm", std::string(code.name)};
    const Outcome text = bench(words);
    EXPECT_EQ(text.code, kWell) << text.err;
    EXPECT_NE(text.out.find("-3.5"), std::string::npos) << text.out;
    Words machine_words = words;
    machine_words.emplace_back("--json");
    const Outcome machine = bench(machine_words);
    ASSERT_EQ(machine.code, kWell) << machine.err;
    const json answer = json::parse(machine.out);
    EXPECT_EQ(answer["algorithm"], code.name);
    EXPECT_EQ(answer["status"], "optimal");
    EXPECT_EQ(answer["cost"], -3.5);
    EXPECT_TRUE(answer["paths"].is_number_integer());
    EXPECT_EQ(answer["paths"], 1);
    EXPECT_EQ(answer["nodes"], 4);
    EXPECT_EQ(answer["arcs"], 4);
    EXPECT_EQ(answer["used_arcs"], json::parse("[[3, 2, 1], [2, 4, 1], [4, 1, 1]]"));
    EXPECT_FALSE(answer.contains("tracks"));
    EXPECT_GE(answer["seconds"], 0.0);
    EXPECT_GE(answer["cpu_seconds"], 0.0);
    if (!answer["certified_bound"].is_null()) {
      EXPECT_LE(answer["certified_bound"], -3.5);
      EXPECT_GE(answer["certified_bound"], -3.5 - 1e-6);
    }
  }
}

TEST_F(ProgramTest, FlowThatCannotBeHasAStatusAndNoCost) {
  std::ofstream(file("g.min")) << "p min 2 1\nn 1 2\nn 2 -2\na 1 2 0 1 3\n";
  const Outcome outcome = bench({"flow", "g.min", "--algorithm", "scf-networksimplex", "--json"});
  EXPECT_EQ(outcome.code, kWell) << outcome.err;
  const json answer = json::parse(outcome.out);
  EXPECT_EQ(answer["status"], "infeasible");
  EXPECT_TRUE(answer["cost"].is_null());
  EXPECT_TRUE(answer["paths"].is_null());
  EXPECT_TRUE(answer["certified_bound"].is_null());
}

TEST_F(ProgramTest, FlowsAreToldPathByPathToThoseWhoAsk) {
  std::ofstream(file("g.min"))
      << "p min 5 4\nn 5 0\nn 1 0\na 5 4 -1\na 4 1 -1\na 5 2 -2\na 2 1 1\n";
  Words words = {"flow", "g.min", "--algorithm", "scf-assignment", "--paths"};
  const Outcome text = bench(words);
  EXPECT_EQ(text.code, kWell) << text.err;
  EXPECT_NE(text.out.find("5 4 1\n"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("5 2 1\n"), std::string::npos) << text.out;
  words.emplace_back("--json");
  EXPECT_EQ(json::parse(bench(words).out)["tracks"], json::parse("[[5, 4, 1], [5, 2, 1]]"));
  std::ofstream(file("d.min")) << "p min 2 1\nn 1 1\nn 2 -1\na 1 2 0 1 3\n";
  expect_refused({"flow", "d.min", "--algorithm", "scf-networksimplex", "--paths"});
}

TEST_F(ProgramTest, FlowsWhoseCostsOverflowAreRefusedWithTheFile) {
  std::ofstream(file("g.min")) << "p min 2 1\nn 1 1000000000000\nn 2 -1000000000000\n"
                                  "a 1 2 0 1000000000000 1000000000\n";
  for (const FlowCode& code : flow_codes()) {
    const Words words = {"flow", "g.min", "--algorithm", std::string(code.name)};
    expect_refused(words);
    EXPECT_TRUE(bench(words).err.starts_with("mda-bench: g.min: ")) << bench(words).err;
  }
}

TEST_F(ProgramTest, BytesOfAGraphFileAreQuoted) {
  std::ofstream(file("g.min")) << "\x9f\x1b[31m\xff 1\n";
  const Words words = {"flow", "g.min", "--algorithm", "scf-lp"};
  expect_refused(words);
  const std::string err = bench(words).err;
  EXPECT_NE(err.find("'\\x9f\\x1b[31m\\xff'"), std::string::npos) << err;
}

TEST_F(ProgramTest, FlowCodesThatDeclineSayWhy) {
  // The capacity of node 2 is not that of disjoint paths.
  std::ofstream(file("g.min"))
      << "p min 3 3\nn 1 2\nn 3 -2\na 1 2 0 2 3\na 2 3 0 2 -3\na 3 1 0 2 0\n";
  expect_refused({"flow", "g.min", "--algorithm", "scf-assignment"});
  const Outcome outcome = bench({"flow", "g.min", "--algorithm", "scf-assignment"});
  EXPECT_NE(outcome.err.find("'scf-assignment' declines: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(", node 1 (line 4)\n"), std::string::npos) << outcome.err;
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
