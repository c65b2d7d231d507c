// Dense axial files: what is read, what is refused, and the optima that another solver found.
#include "harness/axial_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/draw.h"
#include "algorithms/testing/tiny_problems.h"
#include "harness/errors.h"
#include "harness/files.h"
#include "harness/judge.h"

namespace mda::testing {
namespace {

const std::string kSmall = "2\n4 1\n3 9\n7 2\n5 6\n";

TEST(AxialFileTest, ReadsEveryCostWhereItBelongs) {
  const AssociationProblem problem = parse_axial3(kSmall, "a.txt");
  EXPECT_TRUE(problem.shape().is_axial);
  EXPECT_EQ(problem.fingerprint(), tiny_problem("axial").problem.fingerprint());
  EXPECT_EQ(parse_axial3("2\r\n 4\t1 \n3 9\n7 2\n5 6\n\n \n", "a.txt").fingerprint(),
            problem.fingerprint());
  EXPECT_EQ(parse_axial3("1\n-2.5e1", "a.txt").cost(0), -25.0);
}

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(parse_axial3(text, "a.txt"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(AxialFileTest, WhatIsNoProblemIsRefusedWithItsLine) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "a.txt:1: "},
      {"\n", "a.txt:1: "},
      {"0\n", "a.txt:1: n is 0"},
      {"-1\n", "a.txt:1: n is -1"},
      {"1.5\n", "a.txt:1: n is 1.5"},
      {"1000000\n", "a.txt:1: n is 1"},
      {"two\n", "a.txt:1: 'two'"},
      {"2 2\n", "a.txt:1: 2 numbers"},
      {"2\n4 1\n3\n7 2\n5 6\n", "a.txt:3: 1 costs where 2"},
      {"2\n4 1\n3 9 9\n7 2\n5 6\n", "a.txt:3: 3 costs where 2"},
      {"2\n4 1\n\n7 2\n5 6\n", "a.txt:3: 0 costs where 2"},
      {"2\n4 1\n3 nan\n7 2\n5 6\n", "a.txt:3: 'nan'"},
      {"2\n4 1\n3 inf\n7 2\n5 6\n", "a.txt:3: 'inf'"},
      {"2\n4 1\n3 1e13\n7 2\n5 6\n", "a.txt:3: '1e13'"},
      {"2\n4 1\n3 9x\n7 2\n5 6\n", "a.txt:3: '9x'"},
      {"2\n4 1\n3 9\n7 2\n", "a.txt:5: the file ends"},
      {kSmall + "1 2\n", "a.txt:6: there is more"}};
  for (const auto& [text, message] : cases) {
    EXPECT_TRUE(refusal(text).starts_with(message)) << refusal(text) << " for " << text;
    EXPECT_EQ(refusal(text).find('\n'), std::string::npos);
  }
}

TEST(AxialFileTest, RandomDamageIsSurvived) {
  Draw draw(1);
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text = kSmall;
    for (int change = draw.below(4); change >= 0; --change) {
      text[static_cast<std::size_t>(draw.below(static_cast<int>(text.size())))] =
          static_cast<char>(draw.below(256));
    }
    static_cast<void>(refusal(text));
  }
}

/// Instances of another project, with the optima that its solver found.
TEST(AxialFileTest, ExactSolversFindTheKnownOptimaAndLagrangiansBracketThem) {
  const char* folder = std::getenv("MDA_AXIAL3");
  if (folder == nullptr || !std::filesystem::exists(folder)) {
    GTEST_SKIP() << "MDA_AXIAL3 does not name the folder of the instances";
  }
  const std::filesystem::path path(folder);
  const auto optima = nlohmann::json::parse(read_file((path / "optima.json").string()));
  ASSERT_FALSE(optima.empty());
  for (const auto& instance : optima) {
    const std::string file = (path / (instance["name"].get<std::string>() + ".txt")).string();
    SCOPED_TRACE(file);
    const AssociationProblem problem = parse_axial3(read_file(file), file);
    std::vector<Player> players;
    for (const char* name : {"exact", "cbc", "lagrangian-sd"}) {
      const CatalogEntry* entry = find_algorithm(name);
      players.push_back({entry, true, entry->make()});
    }
    const Verdicts verdicts = judge(problem, solve_all(problem, players, {.time_limit_s = 60.0}));
    const double optimum = instance["opt"];
    for (int exact = 0; exact < 2; ++exact) {
      EXPECT_EQ(verdicts.attempts[static_cast<std::size_t>(exact)].solution.status,
                Status::kOptimal);
      EXPECT_NEAR(verdicts.attempts[static_cast<std::size_t>(exact)].examined.cost, optimum, 1e-6);
    }
    const Attempt& lagrangian = verdicts.attempts[2];
    ASSERT_TRUE(lagrangian.certified_bound.has_value());
    EXPECT_LE(*lagrangian.certified_bound, instance["lp"].get<double>() + 1e-5);
    EXPECT_GE(*lagrangian.certified_bound, 0.0);
    EXPECT_GE(lagrangian.examined.cost, optimum - 1e-6);
  }
}

}  // namespace
}  // namespace mda::testing
