// Flows as users of the program meet them.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "algorithms/catalog.h"
#include "harness/errors.h"
#include "harness/testing/program_test.h"

namespace mda::testing {
namespace {

using nlohmann::json;

class ProgramFlowTest : public ProgramTest {};

TEST_F(ProgramFlowTest, FlowsAreFoundByEveryCode) {
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

TEST_F(ProgramFlowTest, FlowThatCannotBeHasAStatusAndNoCost) {
  std::ofstream(file("g.min")) << "p min 2 1\nn 1 2\nn 2 -2\na 1 2 0 1 3\n";
  const Outcome outcome = bench({"flow", "g.min", "--algorithm", "scf-networksimplex", "--json"});
  EXPECT_EQ(outcome.code, kWell) << outcome.err;
  const json answer = json::parse(outcome.out);
  EXPECT_EQ(answer["status"], "infeasible");
  EXPECT_TRUE(answer["cost"].is_null());
  EXPECT_TRUE(answer["paths"].is_null());
  EXPECT_TRUE(answer["certified_bound"].is_null());
}

TEST_F(ProgramFlowTest, FlowsAreToldPathByPathToThoseWhoAsk) {
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

TEST_F(ProgramFlowTest, FlowsWhoseCostsOverflowAreRefusedWithTheFile) {
  std::ofstream(file("g.min")) << "p min 2 1\nn 1 1000000000000\nn 2 -1000000000000\n"
                                  "a 1 2 0 1000000000000 1000000000\n";
  for (const FlowCode& code : flow_codes()) {
    const Words words = {"flow", "g.min", "--algorithm", std::string(code.name)};
    expect_refused(words);
    EXPECT_TRUE(bench(words).err.starts_with("mda-bench: g.min: ")) << bench(words).err;
  }
}

TEST_F(ProgramFlowTest, BytesOfAGraphFileAreQuoted) {
  std::ofstream(file("g.min")) << "\x9f\x1b[31m\xff 1\n";
  const Words words = {"flow", "g.min", "--algorithm", "scf-lp"};
  expect_refused(words);
  const std::string err = bench(words).err;
  EXPECT_NE(err.find("'\\x9f\\x1b[31m\\xff'"), std::string::npos) << err;
}

TEST_F(ProgramFlowTest, FlowCodesThatDeclineSayWhy) {
  // The capacity of node 2 is not that of disjoint paths.
  std::ofstream(file("g.min"))
      << "p min 3 3\nn 1 2\nn 3 -2\na 1 2 0 2 3\na 2 3 0 2 -3\na 3 1 0 2 0\n";
  expect_refused({"flow", "g.min", "--algorithm", "scf-assignment"});
  const Outcome outcome = bench({"flow", "g.min", "--algorithm", "scf-assignment"});
  EXPECT_NE(outcome.err.find("'scf-assignment' declines: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(", node 1 (line 4)\n"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace mda::testing
