#include "scenarios/static3/sensor_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

#include "scenarios/static3/sensor_points.h"

namespace mda::testing {
namespace {

constexpr std::uint64_t kSeed = 1;

ScenarioSpec grid_point() { return sensor_point(36, SensorLayout::kGrid, 0.2, 0.1); }

std::vector<std::tuple<double, double, int>> numbers(const SensorScene& scene) {
  std::vector<std::tuple<double, double, int>> all;
  for (const auto& reports : scene.reports) {
    for (const SensorReport& r : reports) all.emplace_back(r.x, r.y, r.target);
  }
  return all;
}

TEST(SensorSceneTest, SameKeySameSceneOtherKeyOtherScene) {
  for (const ScenarioSpec& spec : sensor_points()) {
    SCOPED_TRACE(spec.name);
    const auto scene = numbers(simulate_sensors(spec, kSeed, 2));
    EXPECT_EQ(numbers(simulate_sensors(spec, kSeed, 2)), scene);
    EXPECT_NE(numbers(simulate_sensors(spec, kSeed, 3)), scene);
    EXPECT_NE(numbers(simulate_sensors(spec, kSeed + 1, 2)), scene);
  }
}

/// Counts, errors and the order of reports over many scenes, within five standard errors.
TEST(SensorSceneTest, DrawsWhatTheScenarioSays) {
  constexpr int kScenes = 400;
  for (const SensorLayout layout : {SensorLayout::kGrid, SensorLayout::kRandom}) {
    const ScenarioSpec spec = sensor_point(36, layout, 0.2, 0.3);
    double detected = 0.0;
    double false_alarms = 0.0;
    double error_square = 0.0;
    double first_is_false = 0.0;
    for (int replicate = 1; replicate <= kScenes; ++replicate) {
      const SensorScene scene = simulate_sensors(spec, kSeed, replicate);
      EXPECT_EQ(scene.side, 6.0);
      for (const auto& reports : scene.reports) {
        std::set<int> targets;
        for (const SensorReport& report : reports) {
          const int column = report.target % 6;
          const int row = report.target / 6;
          if (report.target == kNoTarget) {
            ++false_alarms;
            continue;
          }
          ++detected;
          EXPECT_TRUE(targets.insert(report.target).second) << "seen twice by one sensor";
          if (layout == SensorLayout::kRandom) continue;
          error_square +=
              std::pow(report.x - (column + 0.5), 2) + std::pow(report.y - (row + 0.5), 2);
        }
        first_is_false += reports.front().target == kNoTarget ? 1.0 : 0.0;
      }
    }
    const double sensors = 3.0 * kScenes;
    EXPECT_NEAR(detected / (36.0 * sensors), 0.7, 5.0 * std::sqrt(0.21 / (36.0 * sensors)));
    EXPECT_NEAR(false_alarms / sensors, 10.8, 5.0 * std::sqrt(10.8 / sensors));
    EXPECT_NEAR(first_is_false / sensors, 0.3, 5.0 * std::sqrt(0.21 / sensors));
    if (layout == SensorLayout::kRandom) continue;
    EXPECT_NEAR(error_square / (2.0 * detected), 0.04, 5.0 * 0.04 / std::sqrt(detected));
  }
}

TEST(SensorSceneTest, RandomLayoutsFillTheSquareAndChange) {
  ScenarioSpec spec = sensor_point(64, SensorLayout::kRandom, 0.2, 0.0);
  spec.three_sensors->sigma_per_spacing = 1e-9;
  spec.world.detection_probability = 1.0;
  double sum = 0.0;
  std::set<double> places;
  for (int replicate = 1; replicate <= 50; ++replicate) {
    const SensorScene scene = simulate_sensors(spec, kSeed, replicate);
    for (const SensorReport& r : scene.reports[0]) {
      EXPECT_TRUE(r.x > -1e-6 && r.x < 8.0 + 1e-6 && r.y > -1e-6 && r.y < 8.0 + 1e-6);
      sum += r.x;
      places.insert(r.x);
    }
  }
  EXPECT_EQ(places.size(), 3200U);
  EXPECT_NEAR(sum / 3200.0, 4.0, 5.0 * 8.0 / std::sqrt(12.0 * 3200.0));
}

TEST(SensorSceneTest, WhatMakesNoSceneIsToldByItsField) {
  using Change = std::function<void(ScenarioSpec&)>;
  const std::vector<std::pair<std::string, Change>> cases = {
      {"targets", [](auto& s) { s.three_sensors->targets = 0; }},
      {"targets", [](auto& s) { s.three_sensors->targets = 35; }},
      {"sigma_per_spacing", [](auto& s) { s.three_sensors->sigma_per_spacing = 0.0; }},
      {"sigma_per_spacing", [](auto& s) { s.three_sensors->sigma_per_spacing = NAN; }},
      {"detection_probability", [](auto& s) { s.world.detection_probability = 0.0; }},
      {"detection_probability", [](auto& s) { s.world.detection_probability = 1.5; }},
      {"false_alarms_per_target", [](auto& s) { s.three_sensors->false_alarms_per_target = -1.0; }},
      {"gate", [](auto& s) { s.model.gate = 0.0; }}};
  EXPECT_EQ(sensor_fault(grid_point()), "");
  for (const auto& [field, change] : cases) {
    ScenarioSpec spec = grid_point();
    change(spec);
    EXPECT_TRUE(sensor_fault(spec).starts_with(field)) << sensor_fault(spec);
    EXPECT_THROW(static_cast<void>(simulate_sensors(spec, kSeed, 1)), std::invalid_argument);
  }
  EXPECT_THROW(static_cast<void>(simulate_sensors(ScenarioSpec{}, kSeed, 1)),
               std::invalid_argument);
}

TEST(SensorPointsTest, ThirtyPointsOfTheStudyAndFourRandomOnes) {
  std::set<std::string> names;
  for (const ScenarioSpec& spec : sensor_points()) names.insert(spec.name);
  EXPECT_EQ(names.size(), 34U);
  EXPECT_EQ(sensor_grid_points().size(), 30U);
  EXPECT_TRUE(names.contains("static3-64-s0.15-f0.3"));
  EXPECT_TRUE(names.contains("static3-36-random-s0.20-f0.1"));
}

}  // namespace
}  // namespace mda::testing
