#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/draw.h"
#include "harness/errors.h"
#include "harness/sweep.h"
#include "harness/testing/temporary_directory.h"
#include "harness/words.h"

namespace mda::testing {
namespace {

const std::string kSweep = R"(name = "mine"
scenarios = ["A", "D"]
scan_periods_s = [8.0, 4]
windows = [3, 5]
replicates = 10
seed = 7
driver = "cbc"
algorithms = ["lp-grp", "cbc"]
time_limit_s = 2.5
)";

TEST(SweepFileTest, ReadsWhatTheContractNames) {
  const Sweep sweep = parse_sweep(kSweep + R"(
[model]
density = "jacobian"
second_plot = "converted"
gate = 16
max_misses = 1
velocity_prior = 0.5
[world]
birth_centre_x_km = -10
birth_side_km = 4.5
initial_targets = 12
target_life_scans = 5
)",
                                  "s.toml");
  EXPECT_EQ(sweep.name, "mine");
  ASSERT_EQ(sweep.scenarios.size(), 2U);
  EXPECT_EQ(sweep.scenarios[0].spec.name, "A");
  EXPECT_EQ(sweep.scenarios[1].spec.name, "D");
  EXPECT_EQ(sweep.scan_periods_s, (std::vector<double>{8.0, 4.0}));
  EXPECT_EQ(sweep.seed, 7U);
  EXPECT_EQ(sweep.driver, "cbc");
  EXPECT_EQ(sweep.algorithms, (std::vector<std::string>{"lp-grp", "cbc"}));
  EXPECT_EQ(sweep.time_limit_s, 2.5);
  for (const ScenarioPlan& plan : sweep.scenarios) {
    EXPECT_EQ(plan.windows, (std::vector<int>{3, 5}));
    EXPECT_EQ(plan.replicates, 10);
    EXPECT_EQ(plan.spec.model.density, Density::kJacobian);
    EXPECT_EQ(plan.spec.model.second_plot, SecondPlot::kConverted);
    EXPECT_EQ(plan.spec.model.newborn, scenario_named("A").model.newborn) << "unsaid";
    EXPECT_EQ(plan.spec.model.gate, 16.0);
    EXPECT_EQ(plan.spec.model.max_misses, 1);
    EXPECT_EQ(plan.spec.model.velocity_prior, 0.5);
    EXPECT_EQ(plan.spec.world.birth_centre_x_km, -10.0);
    EXPECT_EQ(plan.spec.world.birth_centre_y_km,
              scenario_named(plan.spec.name).world.birth_centre_y_km);
    EXPECT_EQ(plan.spec.world.birth_side_km, 4.5);
    EXPECT_EQ(plan.spec.world.initial_targets, 12);
    EXPECT_EQ(plan.spec.world.target_life_scans, 5);
  }
}

TEST(SweepFileTest, WhatIsNotSaidHasDefaults) {
  const Sweep sweep =
      parse_sweep("name = 'x'\nscenarios = ['B']\nwindows = [3]\nalgorithms = ['lp']", "s.toml");
  EXPECT_EQ(sweep.seed, 1U);
  EXPECT_EQ(sweep.scan_periods_s, std::vector<double>{8.0});
  EXPECT_EQ(sweep.driver, reference_algorithm().name);
  EXPECT_EQ(sweep.scenarios[0].replicates, 1);
  EXPECT_EQ(sweep.time_limit_s, 10.0);
}

template <typename Words, typename Choice>
void expect_words(const Words& words, const char* key, Choice TrackerModel::*choice) {
  for (const auto& word : words) {
    const std::string text = kSweep + "[model]\n" + key + " = \"" + std::string(word.text) + "\"\n";
    const Sweep sweep = parse_sweep(text, "s.toml");
    EXPECT_EQ(sweep.scenarios[1].spec.model.*choice, word.choice) << text;
    EXPECT_EQ(word_of(words, word.choice), word.text);
  }
}

TEST(SweepFileTest, EveryWordOfTheModelMeansItsChoice) {
  expect_words(kDensityWords, "density", &TrackerModel::density);
  expect_words(kSecondPlotWords, "second_plot", &TrackerModel::second_plot);
  expect_words(kTrailingMissesWords, "trailing_misses", &TrackerModel::trailing_misses);
  expect_words(kNewbornWords, "newborn", &TrackerModel::newborn);
  expect_words(kRowRuleWords, "rows", &TrackerModel::rows);
  expect_words(kTrackUpdateWords, "update", &TrackerModel::update);
}

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(parse_sweep(text, "s.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

struct Malformed {
  std::string text;
  const char* message;
};

/// The good sweep with the line of `key` (or a new one at its end) replaced by "key = value".
std::string with(const std::string& key, const std::string& value) {
  std::string text = kSweep;
  const auto begin = text.find(key + " =");
  if (begin == std::string::npos) return text + key + " = " + value + "\n";
  return text.replace(begin, text.find('\n', begin) - begin, key + " = " + value);
}

TEST(SweepFileTest, WrongKeysAndTypesAreRefusedWithTheirLine) {
  const std::vector<Malformed> cases = {
      {kSweep + "window = [3]\n", "s.toml:10: unknown key 'window'"},
      {kSweep + "\n\n[modell]\ngate = 3\n", "s.toml:12: unknown key 'modell'"},
      {kSweep + "[model]\ngates = 3\n", "s.toml:11: unknown key 'model.gates'"},
      {kSweep + "[world]\nscans = 3\n", "s.toml:11: unknown key 'world.scans'"},
      {with("name", "3"), "s.toml:1: 'name' must be a string"},
      {with("scenarios", "\"A\""), "s.toml:2: 'scenarios' must be a list of strings"},
      {with("scenarios", "[\"A\", 1]"), "s.toml:2: 'scenarios' must be strings"},
      {with("scan_periods_s", "8.0"), "s.toml:3: 'scan_periods_s' must be a list"},
      {with("scan_periods_s", "[true]"), "s.toml:3: 'scan_periods_s'"},
      {with("scan_periods_s", "[\"8\"]"), "s.toml:3: 'scan_periods_s'"},
      {with("windows", "[3.0]"), "s.toml:4: 'windows' must be integers"},
      {with("windows", "[3000000000]"), "s.toml:4: 'windows'"},
      {with("windows", "[[3]]"), "s.toml:4: 'windows'"},
      {with("replicates", "3000000000"),
       "s.toml:5: 'replicates' must be an integer in range, but it is 3000000000"},
      {with("replicates", "1.5"), "s.toml:5: 'replicates' must be an integer"},
      {with("replicates", "\"ten\""), "s.toml:5: 'replicates'"},
      {with("seed", "-1"), "s.toml:6: 'seed'"},
      {with("seed", "true"), "s.toml:6: 'seed'"},
      {with("driver", "[\"cbc\"]"), "s.toml:7: 'driver'"},
      {with("time_limit_s", "\"1\""), "s.toml:9: 'time_limit_s'"},
      {with("model", "3"), "s.toml:10: 'model' must be a table"},
      {with("model", "[{}]"), "s.toml:10: 'model' must be a table"},
      {kSweep + "[model]\ndensity = \"cubic\"\n", "s.toml:11: 'model.density' must be one of"},
      {kSweep + "[model]\nrows = 1\n", "s.toml:11: 'model.rows' must be one of"},
      {kSweep + "[model]\ngate = \"9\"\n", "s.toml:11: 'model.gate'"},
      {kSweep + "[model]\nmax_misses = 2.0\n", "s.toml:11: 'model.max_misses'"},
      {kSweep + "replicates = 2\n", "s.toml:10: "},
      {kSweep + "name\n", "s.toml:10: "},
      {kSweep + "seed = 99999999999999999999\n", "s.toml:10: "},
      {"name = \"", "s.toml:1: "},
      {"\n\n= 3", "s.toml:3: "},
  };
  for (const Malformed& c : cases) {
    EXPECT_TRUE(refusal(c.text).starts_with(c.message)) << refusal(c.text) << "\n for " << c.text;
  }
}

TEST(SweepFileTest, WrongValuesAreRefusedWithTheFile) {
  const std::vector<Malformed> cases = {
      {"", "'name'"},
      {with("name", "\"\""), "'name'"},
      {with("name", "\"../../elsewhere\""), "'name'"},
      {with("name", "\"two words\""), "'name'"},
      {with("scenarios", "[]"), "scenarios: nothing is listed"},
      {with("scenarios", "[\"E\"]"), "unknown scenario 'E'"},
      {with("scenarios", "[\"A\", \"A\"]"), "scenarios: something is listed twice"},
      {with("algorithms", "[]"), "algorithms: nothing is listed"},
      {with("algorithms", "[\"magic\"]"), "unknown algorithm 'magic'"},
      {with("algorithms", "[\"lp\", \"lp\"]"), "algorithms: something is listed twice"},
      {with("driver", "\"magic\""), "driver: unknown algorithm 'magic'"},
      {with("windows", "[]"), "windows: nothing is listed"},
      {with("windows", "[0]"), "window 0"},
      {with("windows", "[3, 3]"), "windows: something is listed twice"},
      {with("windows", "[31]"), "window 31"},
      {with("scan_periods_s", "[]"), "scan periods: nothing is listed"},
      {with("scan_periods_s", "[0]"), "scan period 0"},
      {with("scan_periods_s", "[nan]"), "scan period nan"},
      {with("scan_periods_s", "[inf]"), "scan period inf"},
      {with("replicates", "0"), "replicates 0"},
      {with("time_limit_s", "0"), "time limit 0"},
      {with("time_limit_s", "nan"), "time limit nan"},
      {kSweep + "[model]\ngate = 0\n", "'model.gate'"},
      {kSweep + "[model]\ngate = nan\n", "'model.gate'"},
      {kSweep + "[model]\nmax_misses = -1\n", "'model.max_misses'"},
      {kSweep + "[model]\nvelocity_prior = -1.0\n", "'model.velocity_prior'"},
      {kSweep + "[world]\nbirth_centre_x_km = inf\n", "birth_centre_x_km"},
      {kSweep + "[world]\nbirth_side_km = 0.0\n", "birth_side_km"},
      {kSweep + "[world]\ninitial_targets = -1\n", "initial_targets"},
      {kSweep + "[world]\ntarget_life_scans = -1\n", "target_life_scans"},
  };
  for (const Malformed& c : cases) {
    EXPECT_TRUE(refusal(c.text).starts_with("s.toml: ")) << refusal(c.text) << " for " << c.text;
    EXPECT_NE(refusal(c.text).find(c.message), std::string::npos) << refusal(c.text);
  }
}

/// A sweep of one point of three sensors, with these lines in [world] and [model].
std::string sensor_sweep(const std::string& world, const std::string& model = "") {
  return "name = \"s\"\nscenarios = [\"static3-36-s0.20-f0.1\"]\nwindows = [3]\n"
         "algorithms = [\"bojilov\"]\n[world]\n" +
         world + "\n[model]\n" + model + "\n";
}

TEST(SweepFileTest, ThreeSensorsHaveTheirOwnKeys) {
  const Sweep sweep = parse_sweep(
      sensor_sweep("sensors = 3\ntargets = 50\nlayout = \"random\"\nsigma_per_spacing = 0.5\n"
                   "false_alarms_per_target = 0.25\ndetection_probability = 0.9",
                   "gate = 15.03"),
      "s.toml");
  const ScenarioSpec& spec = sweep.scenarios.at(0).spec;
  EXPECT_EQ(spec.three_sensors->targets, 50);
  EXPECT_EQ(spec.three_sensors->layout, SensorLayout::kRandom);
  EXPECT_EQ(spec.three_sensors->sigma_per_spacing, 0.5);
  EXPECT_EQ(spec.three_sensors->false_alarms_per_target, 0.25);
  EXPECT_EQ(spec.world.detection_probability, 0.9);
  EXPECT_EQ(spec.model.gate, 15.03);
}

TEST(SweepFileTest, ThreeSensorsThatMakeNoSceneAreRefused) {
  const std::vector<Malformed> cases = {
      {sensor_sweep("sensors = 2"), "'world.sensors' is 2"},
      {sensor_sweep("targets = 0"), "targets: 0"},
      {sensor_sweep("targets = 35"), "targets: 35"},
      {sensor_sweep("detection_probability = 0.0"), "detection_probability"},
      {sensor_sweep("sigma_per_spacing = 0"), "sigma_per_spacing"},
      {sensor_sweep("sigma_per_spacing = nan"), "sigma_per_spacing"},
      {sensor_sweep("false_alarms_per_target = -0.1"), "false_alarms_per_target"},
      {sensor_sweep("", "gate = 0"), "'model.gate'"},
      {sensor_sweep("layout = \"hexagons\""), "'world.layout' must be one of"},
      {kSweep + "[world]\nsensors = 3\n", "unknown key 'world.sensors'"}};
  for (const Malformed& c : cases) {
    EXPECT_TRUE(refusal(c.text).starts_with("s.toml:")) << refusal(c.text) << " for " << c.text;
    EXPECT_NE(refusal(c.text).find(c.message), std::string::npos) << refusal(c.text);
  }
}

TEST(SweepFileTest, RandomBytesAndRandomDamageAreSurvived) {
  Draw draw(1);
  for (int trial = 0; trial < 3000; ++trial) {
    const bool damaged = trial % 2 == 0;
    std::string text =
        damaged ? kSweep : std::string(static_cast<std::size_t>(draw.below(80)), ' ');
    const int changes = damaged ? 1 + draw.below(3) : static_cast<int>(text.size());
    for (int i = 0; i < changes; ++i) {
      const int at = damaged ? draw.below(static_cast<int>(text.size())) : i;
      text[static_cast<std::size_t>(at)] = static_cast<char>(draw.below(256));
    }
    const std::string answer = refusal(text);
    EXPECT_TRUE(answer == "taken" || answer.starts_with("s.toml:")) << answer;
  }
  EXPECT_TRUE(refusal("a = " + std::string(100000, '[')).starts_with("s.toml:1: "));
}

TEST(SweepFileTest, LoadsFilesByTheirEnding) {
  const TemporaryDirectory directory;
  std::ofstream(directory.file("s.toml")) << kSweep;
  EXPECT_EQ(load_sweep(directory.file("s.toml")).name, "mine");
  EXPECT_THROW(static_cast<void>(load_sweep(directory.file("absent.toml"))), InputError);
  std::filesystem::create_directory(directory.path() / "folder.toml");
  EXPECT_THROW(static_cast<void>(load_sweep(directory.file("folder.toml"))), InputError);
}

TEST(SweepFile, ScenesOfADurationHaveAScanPeriodOfTheirOwn) {
  const std::string text = R"(name = "own"
scenarios = ["A", "lee-ten", "battistelli-1"]
windows = [1]
algorithms = ["gnn"]
)";
  const Sweep own = parse_sweep(text, "own.toml");
  EXPECT_EQ(scan_periods_of(own, own.scenarios[0]), std::vector<double>{8.0});
  EXPECT_EQ(scan_periods_of(own, own.scenarios[1]), std::vector<double>{1.0});
  EXPECT_EQ(scan_periods_of(own, own.scenarios[2]), std::vector<double>{5.0});
  const Sweep given = parse_sweep(text + "scan_periods_s = [2.0]\n", "given.toml");
  EXPECT_EQ(scan_periods_of(given, given.scenarios[1]), std::vector<double>{2.0});
}

}  // namespace
}  // namespace mda::testing
