#include "harness/cli.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "harness/errors.h"

namespace mda::testing {
namespace {

using Words = std::vector<std::string>;

Command parsed(const Words& words) {
  std::vector<const char*> argv = {"mda-bench"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  return parse_command_line(static_cast<int>(argv.size()), argv.data()).value();
}

template <typename T>
T parsed_as(const Words& words) {
  return std::get<T>(parsed(words));
}

std::string refusal(const Words& words) {
  try {
    static_cast<void>(parsed(words));
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(CliTest, Lists) {
  EXPECT_EQ(parsed_as<ListCommand>({"list", "algorithms"}).kind, ListKind::kAlgorithms);
  EXPECT_EQ(parsed_as<ListCommand>({"list", "scenarios"}).kind, ListKind::kScenarios);
  EXPECT_EQ(parsed_as<ListCommand>({"list", "sweeps"}).kind, ListKind::kSweeps);
  EXPECT_FALSE(parsed_as<ListCommand>({"list", "sweeps"}).json);
  EXPECT_TRUE(parsed_as<ListCommand>({"list", "--json", "sweeps"}).json);
}

TEST(CliTest, RunsWithoutOptionsLeaveTheSweepAsItIs) {
  const auto command = parsed_as<RunCommand>({"run", "smoke"});
  EXPECT_EQ(command.sweep, "smoke");
  EXPECT_EQ(command.out, "");
  EXPECT_EQ(command.workers, 0);
  EXPECT_FALSE(command.json);
  EXPECT_TRUE(command.changes.algorithms.empty());
  EXPECT_TRUE(command.changes.scenarios.empty());
  EXPECT_TRUE(command.changes.windows.empty());
  EXPECT_TRUE(command.changes.scan_periods_s.empty());
  EXPECT_EQ(command.changes.replicates, 0);
  EXPECT_EQ(command.changes.seed, 0U);
  EXPECT_EQ(command.changes.time_limit_s, 0.0);
  EXPECT_EQ(command.arguments, (Words{"run", "smoke"}));
}

TEST(CliTest, RunsWithEveryOption) {
  const Words words = {"run",
                       "my file.toml",
                       "--out",
                       "a b",
                       "--workers",
                       "3",
                       "--json",
                       "--algorithms",
                       "lp,exact",
                       "--scenarios=A,B",
                       "--windows",
                       "3,5",
                       "--scan-periods",
                       "8,2.5",
                       "--replicates",
                       "12",
                       "--seed",
                       "18446744073709551615",
                       "--time-limit",
                       "1e-3"};
  const auto command = parsed_as<RunCommand>(words);
  EXPECT_EQ(command.sweep, "my file.toml");
  EXPECT_EQ(command.out, "a b");
  EXPECT_EQ(command.workers, 3);
  EXPECT_TRUE(command.json);
  EXPECT_EQ(command.changes.algorithms, (Words{"lp", "exact"}));
  EXPECT_EQ(command.changes.scenarios, (Words{"A", "B"}));
  EXPECT_EQ(command.changes.windows, (std::vector<int>{3, 5}));
  EXPECT_EQ(command.changes.scan_periods_s, (std::vector<double>{8.0, 2.5}));
  EXPECT_EQ(command.changes.replicates, 12);
  EXPECT_EQ(command.changes.seed, 18446744073709551615U);
  EXPECT_EQ(command.changes.time_limit_s, 1e-3);
  EXPECT_EQ(command.arguments, words);
}

TEST(CliTest, Exports) {
  const auto plain =
      parsed_as<ExportCommand>({"export", "C", "--scan", "4", "--window", "3", "--format", "lp"});
  EXPECT_EQ(plain.scenario, "C");
  EXPECT_EQ(plain.scan, 4);
  EXPECT_EQ(plain.window_k, 3);
  EXPECT_EQ(plain.replicate, 1);
  EXPECT_FALSE(plain.scan_period_s.has_value());
  EXPECT_EQ(plain.seed, 1U);
  EXPECT_EQ(plain.format, WindowFormat::kLp);
  EXPECT_EQ(plain.out, "");
  const auto full = parsed_as<ExportCommand>(
      {"export", "D", "--scan", "4", "--window", "3", "--format", "mps", "--replicate", "5",
       "--scan-period", "2", "--seed", "9", "--out", "x.mps"});
  EXPECT_EQ(full.replicate, 5);
  EXPECT_EQ(full.scan_period_s, 2.0);
  EXPECT_EQ(full.seed, 9U);
  EXPECT_EQ(full.format, WindowFormat::kMps);
  EXPECT_EQ(full.out, "x.mps");
}

TEST(CliTest, Solves) {
  const auto command = parsed_as<SolveCommand>({"solve", "w.json", "--algorithm", "exact"});
  EXPECT_EQ(command.file, "w.json");
  EXPECT_EQ(command.algorithm, "exact");
  EXPECT_EQ(command.time_limit_s, 60.0);
  EXPECT_FALSE(command.json);
}

TEST(CliTest, Flows) {
  const auto command = parsed_as<FlowCommand>({"flow", "g.min", "--algorithm", "any", "--json"});
  EXPECT_EQ(command.file, "g.min");
  EXPECT_EQ(command.algorithm, "any");
  EXPECT_TRUE(command.json);
}

TEST(CliTest, BadUsageIsOneSentenceThatNamesTheOption) {
  const Words window = {"export", "A", "--scan", "5", "--window", "3"};
  const auto with = [](Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const Words run = {"run", "smoke"};
  const Words solve = {"solve", "w.json", "--algorithm", "lp"};
  const std::vector<std::pair<Words, const char*>> cases = {
      {{}, "a command is missing"},
      {{"dance"}, "dance"},
      {{"list"}, "what"},
      {{"list", "cats"}, "cats"},
      {{"list", "0"}, "what"},
      {{"run"}, "sweep"},
      {with(run, {"extra"}), "extra"},
      {with(run, {"--colour", "red"}), "--colour"},
      {with(run, {"--workers", "0"}), "--workers"},
      {with(run, {"--workers", "-2"}), "--workers"},
      {with(run, {"--workers", "1.5"}), "--workers"},
      {with(run, {"--workers", "1000000"}), "--workers"},
      {with(run, {"--windows", "0"}), "--windows"},
      {with(run, {"--windows", "-3"}), "--windows"},
      {with(run, {"--windows", "three"}), "--windows"},
      {with(run, {"--windows", ""}), "--windows"},
      {with(run, {"--windows"}), "--windows"},
      {with(run, {"--scan-periods", "0"}), "--scan-periods"},
      {with(run, {"--scan-periods", "-8"}), "--scan-periods"},
      {with(run, {"--scan-periods", "nan"}), "--scan-periods"},
      {with(run, {"--scan-periods", "inf"}), "--scan-periods"},
      {with(run, {"--replicates", "0"}), "--replicates"},
      {with(run, {"--replicates", "99999999999999999999999"}), "--replicates"},
      {with(run, {"--seed", "0"}), "--seed"},
      {with(run, {"--seed", "-1"}), "--seed"},
      {with(run, {"--seed", "18446744073709551616"}), "--seed"},
      {with(run, {"--seed", "1.5"}), "--seed"},
      {with(run, {"--seed", "0x10"}), "--seed"},
      {with(run, {"--seed", "010"}), "--seed"},
      {with(run, {"--seed", ""}), "--seed"},
      {with(run, {"--time-limit", "0"}), "--time-limit"},
      {with(run, {"--time-limit", "nan"}), "--time-limit"},
      {with(run, {"--time-limit", "inf"}), "--time-limit"},
      {with(run, {"--time-limit", "soon"}), "--time-limit"},
      {window, "--format"},
      {with(window, {"--format", "xls"}), "--format"},
      {with(window, {"--format", "1"}), "--format"},
      {with(window, {"--format", "json", "--scan-period", "nan"}), "--scan-period"},
      {with(window, {"--format", "json", "--replicate", "0"}), "--replicate"},
      {with(window, {"--format", "json", "--seed", "-3"}), "--seed"},
      {{"export", "A", "--window", "3", "--format", "lp"}, "--scan"},
      {{"export", "A", "--scan", "3", "--format", "lp"}, "--window"},
      {{"export", "A", "--scan", "x", "--window", "3", "--format", "lp"}, "--scan"},
      {{"solve", "w.json"}, "--algorithm"},
      {with(solve, {"--time-limit", "nan"}), "--time-limit"},
      {with(solve, {"--time-limit", "1e300"}), "--time-limit"},
  };
  for (const auto& [words, name] : cases) {
    const std::string message = refusal(words);
    EXPECT_NE(message.find(name), std::string::npos) << message << " for " << name;
    EXPECT_NE(message.find("(see --help)"), std::string::npos) << message << " for " << name;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(CliTest, ChoicesAreAnsweredWithTheirWords) {
  EXPECT_NE(refusal({"list", "cats"}).find("algorithms,scenarios,sweeps"), std::string::npos);
  EXPECT_NE(refusal({"export", "A", "--scan", "5", "--window", "3", "--format", "xls"})
                .find("json,lp,mps"),
            std::string::npos);
}

}  // namespace
}  // namespace mda::testing
