// TrackForest against a plain forest of the same definition, over whole scenes.
#include "scenarios/hypotheses/track_forest.h"

#include <gtest/gtest.h>

#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/testing/draw.h"
#include "scenarios/groups.h"
#include "scenarios/testing/choices.h"
#include "scenarios/testing/lock_step.h"
#include "scenarios/world/simulate.h"

namespace mda::testing {
namespace {

constexpr std::uint64_t kSeed = 1;

/// By which rule columns are chosen before each decision.
enum class Choice { kCheapest, kRandom, kNone };

std::vector<int> choose(Choice choice, const AssociationProblem& problem, Draw& draw) {
  switch (choice) {
    case Choice::kCheapest:
      return cheapest_that_fit(problem);
    case Choice::kRandom: {
      std::vector<int> order = draw.permutation(problem.columns());
      std::erase_if(order, [&](int) { return draw.chance(0.2); });
      return those_that_fit(problem, order);
    }
    case Choice::kNone:
      break;
  }
  return {};
}

/// Plays a scene through both forests; stops at the first difference.
Tally play(const ScenarioSpec& spec, int window_k, int replicate, Choice choice) {
  LockStep game(spec, window_k);
  Draw draw(static_cast<std::uint64_t>(replicate));
  for (const Scan& scan : simulate(spec, kSeed, replicate).scans) {
    const std::string where = spec.name + ", K = " + std::to_string(window_k) + ", replicate " +
                              std::to_string(replicate) + ", scan " +
                              std::to_string(game.forest().newest_scan() + 1) + ": ";
    std::string difference = game.grow(scan);
    if (difference.empty()) {
      difference = game.decide(choose(choice, game.window().problem, draw));
    }
    if (!difference.empty()) {
      ADD_FAILURE() << where << difference;
      break;
    }
  }
  return game.tally();
}

ScenarioSpec shortened(const char* group, int scans) {
  ScenarioSpec spec = *find_scenario(group);
  spec.world.scans = scans;
  return spec;
}

struct Case {
  std::string name;
  const char* group = "A";
  int window_k = 3;
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class TrackForestGroups : public ::testing::TestWithParam<Case> {};

std::vector<Case> groups_and_windows() {
  std::vector<Case> cases;
  for (const char* group : {"A", "B", "C", "D"}) {
    for (const int window_k : {1, 2, 3, 5, 7}) {
      cases.push_back({group + std::to_string(window_k), group, window_k});
    }
  }
  return cases;
}

TEST_P(TrackForestGroups, CheapestChoice) {
  const Case& c = GetParam();
  Tally tally;
  for (int replicate = 1; replicate <= 3; ++replicate) {
    tally = play(*find_scenario(c.group), c.window_k, replicate, Choice::kCheapest);
    if (c.window_k > 1) {
      EXPECT_GT(tally.columns, 0);
    }
  }
  if (c.window_k >= 3) {
    EXPECT_GT(tally.long_columns, 50);
    EXPECT_GT(tally.fixed_tracks, 20);
  }
  if (c.window_k >= 5) {
    EXPECT_GT(tally.ended_columns, 0);
  }
}

TEST_P(TrackForestGroups, RandomChoice) {
  const Case& c = GetParam();
  const ScenarioSpec& spec = *find_scenario(c.group);
  const Tally tally = play(spec, c.window_k, 4, Choice::kRandom);
  if (c.window_k > 1) {
    EXPECT_GT(tally.columns, 0);
  }
}

TEST_P(TrackForestGroups, NothingChosen) {
  const Case& c = GetParam();
  const Tally tally = play(shortened(c.group, 15), c.window_k, 5, Choice::kNone);
  EXPECT_EQ(tally.fixed_tracks, 0);
}

INSTANTIATE_TEST_SUITE_P(LockStep, TrackForestGroups, ::testing::ValuesIn(groups_and_windows()),
                         [](const auto& test) { return test.param.name; });

struct ModelCase {
  std::string name;
  TrackerModel model;
};

std::ostream& operator<<(std::ostream& out, const ModelCase& c) { return out << c.name; }

class TrackForestModels : public ::testing::TestWithParam<ModelCase> {};

/// Every value of every choice alone, and some that meet in the same lines of code together.
std::vector<ModelCase> models() {
  using enum Density;
  using enum SecondPlot;
  using enum TrailingMisses;
  using enum Newborn;
  const RowRule equality = RowRule::kEquality;
  return {
      {"Jacobian", {.density = kJacobian}},
      {"PolarUniform", {.density = kPolarUniform}},
      {"PlainEkf", {.second_plot = kPlainEkf}},
      {"IteratedEkf", {.second_plot = kIteratedEkf}},
      {"Converted", {.second_plot = kConverted}},
      {"AllowedMisses", {.trailing_misses = kAllowed}},
      {"LiveMisses", {.trailing_misses = kLiveOnly}},
      {"NoMisses", {.trailing_misses = kNone}},
      {"SinglePlot", {.newborn = kSinglePlot}},
      {"Equality", {.rows = equality}},
      {"NarrowGate", {.gate = 4.6}},
      {"SlowNewborn", {.velocity_prior = 0.3}},
      {"SurvivesNoMiss", {.max_misses = 0}},
      {"SurvivesOneMiss", {.max_misses = 1}},
      {"SurvivesThreeMisses", {.max_misses = 3}},
      {"NoMissAllowedOfNone", {.trailing_misses = kAllowed, .max_misses = 0}},
      {"LiveOfThree", {.trailing_misses = kLiveOnly, .newborn = kSinglePlot, .max_misses = 3}},
      {"NoneOfOne", {.trailing_misses = kNone, .rows = equality, .max_misses = 1}},
      {"ConvertedOfThree", {.density = kJacobian, .second_plot = kConverted, .max_misses = 3}},
      {"SingleEquality", {.density = kPolarUniform, .newborn = kSinglePlot, .rows = equality}},
  };
}

TEST_P(TrackForestModels, WideGroup) {
  ScenarioSpec spec = *find_scenario("B");
  spec.model = GetParam().model;
  for (const int window_k : {3, 5, 7}) {
    const Tally tally = play(spec, window_k, 1, Choice::kCheapest);
    EXPECT_GT(tally.columns, 100);
    if (window_k == 7) {
      EXPECT_GT(tally.ended_columns, 0);
    }
    play(spec, window_k, 2, Choice::kRandom);
  }
}

TEST_P(TrackForestModels, PackedGroup) {
  ScenarioSpec spec = shortened("D", 18);
  spec.model = GetParam().model;
  for (const int window_k : {2, 4}) {
    EXPECT_GT(play(spec, window_k, 3, Choice::kRandom).columns, 100);
  }
}

INSTANTIATE_TEST_SUITE_P(LockStep, TrackForestModels, ::testing::ValuesIn(models()),
                         [](const auto& test) { return test.param.name; });

/// With K = p + 1 a track may be fixed while it has one plot, and get its second and third after
/// the forest has forgotten the scan of the first.
TEST(TrackForestTest, PairsOutliveTheScanOfTheirBirth) {
  const Tally tally = play(*find_scenario("C"), 3, 1, Choice::kRandom);
  EXPECT_GT(tally.orphaned_pairs, 0);
}

TEST(TrackForestTest, RefusesChoicesThatShareATrack) {
  const ScenarioSpec& spec = *find_scenario("D");
  const Scene scene = simulate(spec, kSeed, 1);
  TrackForest forest;
  WindowExtractor extractor;
  forest.reset(spec.world, spec.model, 2);
  for (const Scan& scan : scene.scans) {
    forest.grow(scan);
    const WindowInstance window = extractor.extract(forest);
    std::vector<int> of_first_track;
    for (int column = 0; forest.tracks() > 0 && column < window.problem.columns(); ++column) {
      if (window.problem.rows_of(column)[0] == 0) of_first_track.push_back(column);
    }
    // Two columns that differ only after the scan that is about to be fixed.
    for (std::size_t i = 1; i < of_first_track.size(); ++i) {
      const int a = window.leaf_of_column[static_cast<std::size_t>(of_first_track[i - 1])];
      const int b = window.leaf_of_column[static_cast<std::size_t>(of_first_track[i])];
      const auto nodes = forest.nodes(forest.newest_scan());
      if (nodes[static_cast<std::size_t>(a)].parent == nodes[static_cast<std::size_t>(b)].parent) {
        EXPECT_THROW(forest.decide(std::vector<int>{a, b}), std::logic_error);
        return;
      }
    }
    forest.decide(leaves_of(window, cheapest_that_fit(window.problem)));
  }
  FAIL() << "no two columns shared a track";
}

TEST(TrackForestTest, RefusesToGrowPastAnOpenDecision) {
  const ScenarioSpec& spec = *find_scenario("A");
  const Scene scene = simulate(spec, kSeed, 1);
  TrackForest forest;
  forest.reset(spec.world, spec.model, 3);
  for (int scan = 0; scan < 4; ++scan) forest.grow(scene.scans[static_cast<std::size_t>(scan)]);
  EXPECT_THROW(forest.grow(scene.scans[4]), std::logic_error);
  forest.decide({});
  EXPECT_NO_THROW(forest.grow(scene.scans[4]));
}

}  // namespace
}  // namespace mda::testing
