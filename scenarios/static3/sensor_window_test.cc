#include "scenarios/static3/sensor_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "scenarios/static3/sensor_points.h"
#include "scenarios/static3/tuple_cost.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr std::uint64_t kSeed = 1;

ScenarioSpec some_point() { return sensor_point(36, SensorLayout::kGrid, 0.25, 0.1); }

/// A uniform integral over the target's position, by the trapezoidal rule: minus the logarithm of
/// the likelihood ratio of the tuple, as c(S) is defined, without any closed form.
double integrated_cost(const std::vector<SensorReport>& reports, const ScenarioSpec& spec) {
  constexpr int kHalf = 200;
  const double sigma = spec.three_sensors->sigma_per_spacing;
  const double detection = spec.world.detection_probability;
  const double lambda = spec.three_sensors->false_alarms_per_target;
  const double width = 10.0 * sigma / kHalf;
  double integral = 0.0;
  for (int a = -kHalf; a <= kHalf; ++a) {
    for (int b = -kHalf; b <= kHalf; ++b) {
      const double x = reports[0].x + a * width;
      const double y = reports[0].y + b * width;
      double density = 1.0;
      for (const SensorReport& r : reports) {
        const double square = std::pow(r.x - x, 2) + std::pow(r.y - y, 2);
        density *=
            std::exp(-square / (2.0 * sigma * sigma)) / (2.0 * std::numbers::pi * sigma * sigma);
      }
      integral += density * width * width;
    }
  }
  const auto k = static_cast<double>(reports.size());
  return -std::log(integral * std::pow(detection, k) * std::pow(1.0 - detection, 3.0 - k) /
                   std::pow(lambda, k));
}

double column_cost(const SensorCosts& costs, const std::vector<SensorReport>& reports) {
  std::vector<const SensorReport*> members;
  for (const SensorReport& report : reports) members.push_back(&report);
  return costs.column(members);
}

TEST(SensorCostsTest, AgreeWithTheIntegralOverTheTarget) {
  const ScenarioSpec spec = some_point();
  const SensorCosts costs(spec);
  const std::vector<SensorReport> triple = {{1.0, 2.0}, {1.3, 1.9}, {0.9, 2.2}};
  const std::vector<SensorReport> pair = {triple[0], triple[1]};
  const double alone = -std::log1p(std::exp(-integrated_cost({triple[0]}, spec)));
  EXPECT_NEAR(costs.alone(), alone, 1e-9);
  EXPECT_NEAR(column_cost(costs, pair), integrated_cost(pair, spec) - 2.0 * alone, 1e-9);
  EXPECT_NEAR(column_cost(costs, triple), integrated_cost(triple, spec) - 3.0 * alone, 1e-9);
  EXPECT_EQ(column_cost(costs, {triple[0]}), 0.0);
}

/// No jump where the false alarms end.
TEST(SensorCostsTest, WithoutFalseAlarmsTheyAreALimit) {
  const std::vector<SensorReport> triple = {{1.0, 2.0}, {1.3, 1.9}, {0.9, 2.2}};
  ScenarioSpec spec = some_point();
  spec.three_sensors->false_alarms_per_target = 0.0;
  const double without = column_cost(SensorCosts(spec), triple);
  spec.three_sensors->false_alarms_per_target = 1e-12;
  EXPECT_NEAR(column_cost(SensorCosts(spec), triple), without, 1e-9);
  EXPECT_TRUE(std::isfinite(without));
}

/// Every report of an ideal scene is better in its target's triple than alone.
TEST(SensorCostsTest, IdealSensorsLeaveNothingAlone) {
  ScenarioSpec spec = sensor_point(36, SensorLayout::kGrid, 0.1, 0.0);
  spec.world.detection_probability = 1.0;
  const SensorScene scene = simulate_sensors(spec, kSeed, 1);
  const WindowInstance window = sensor_window(spec, scene);
  std::set<std::vector<int>> columns;
  for (int j = 0; j < window.problem.columns(); ++j) {
    const auto rows = window.problem.rows_of(j);
    EXPECT_TRUE(std::isfinite(window.problem.cost(j)));
    columns.emplace(rows.begin(), rows.end());
  }
  const auto truth = true_tuples(scene);
  EXPECT_EQ(truth.size(), 36U);
  for (const auto& tuple : truth) EXPECT_TRUE(columns.contains(tuple));
}

/// All tuples of two and three, their costs by the tuple cost, in no hurry.
std::map<std::vector<int>, double> all_tuples(const SensorScene& scene, const Views& views) {
  std::map<std::vector<int>, double> tuples;
  const SensorView& view = *views.sensors;
  std::array<std::vector<int>, 3> choices = view.row;
  for (auto& choice : choices) choice.push_back(kNoRow);
  for (const int a : choices[0]) {
    for (const int b : choices[1]) {
      for (const int c : choices[2]) {
        std::vector<int> rows = {a, b, c};
        const double cost = views.tuple_cost({.rows = rows});
        std::erase(rows, kNoRow);
        if (rows.size() >= 2) tuples.emplace(rows, cost);
      }
    }
  }
  const auto n = [&](int s) { return scene.reports[index(s)].size(); };
  EXPECT_EQ(tuples.size(), n(0) * n(1) + n(0) * n(2) + n(1) * n(2) + n(0) * n(1) * n(2));
  return tuples;
}

/// The grid finds what looking at everything finds, and the gate of the points cuts nothing off.
TEST(SensorWindowTest, ColumnsAreAllTuplesOfNegativeCost) {
  for (const ScenarioSpec& spec : sensor_points()) {
    if (spec.three_sensors->targets > 36) continue;
    SCOPED_TRACE(spec.name);
    const SensorScene scene = simulate_sensors(spec, kSeed, 1);
    WindowInstance window = sensor_window(spec, scene);
    attach_sensor_view(spec, scene, window);
    const AssociationProblem& problem = window.problem;
    const auto tuples = all_tuples(scene, *problem.views());
    EXPECT_EQ(window.ungated_columns, static_cast<double>(tuples.size()));
    std::map<std::vector<int>, double> columns;
    for (int j = 0; j < problem.columns(); ++j) {
      const auto rows = problem.rows_of(j);
      columns.emplace(std::vector(rows.begin(), rows.end()), problem.cost(j));
    }
    EXPECT_EQ(static_cast<int>(columns.size()), problem.columns());
    for (const auto& [rows, cost] : tuples) {
      EXPECT_EQ(columns.contains(rows), cost < 0.0);
      if (cost < 0.0) {
        EXPECT_EQ(columns.at(rows), cost);
      }
    }
    EXPECT_EQ(problem.shape().dimensions, 3);
    EXPECT_TRUE(problem.shape().has_sensors);
  }
}

TEST(SensorWindowTest, ANarrowGateLeavesOutWhatIsFartherApart) {
  ScenarioSpec spec = some_point();
  const SensorScene scene = simulate_sensors(spec, kSeed, 1);
  const AssociationProblem wide = sensor_window(spec, scene).problem;
  spec.model.gate = 2.0;
  WindowInstance narrow = sensor_window(spec, scene);
  attach_sensor_view(spec, scene, narrow);
  const SensorView& view = *narrow.problem.views()->sensors;
  EXPECT_LT(narrow.problem.columns(), wide.columns());
  for (int j = 0; j < narrow.problem.columns(); ++j) {
    const auto rows = narrow.problem.rows_of(j);
    for (std::size_t a = 1; a < rows.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const int s = narrow.problem.dimension(rows[b]) - 1;
        const int t = narrow.problem.dimension(rows[a]) - 1;
        EXPECT_LE(
            view.between(s, rows[b] - view.row[index(s)][0], t, rows[a] - view.row[index(t)][0]),
            2.0);
      }
    }
  }
}

TEST(SensorWindowTest, DistancesAreSymmetricAndChiSquare) {
  ScenarioSpec spec = sensor_point(36, SensorLayout::kGrid, 0.02, 0.0);
  spec.world.detection_probability = 1.0;
  double sum = 0.0;
  constexpr int kScenes = 30;
  for (int replicate = 1; replicate <= kScenes; ++replicate) {
    const SensorScene scene = simulate_sensors(spec, kSeed, replicate);
    WindowInstance window = sensor_window(spec, scene);
    attach_sensor_view(spec, scene, window);
    const SensorView& view = *window.problem.views()->sensors;
    for (int i = 0; i < view.reports(0); ++i) {
      for (int j = 0; j < view.reports(2); ++j) {
        EXPECT_EQ(view.between(0, i, 2, j), view.between(2, j, 0, i));
        const bool same = scene.reports[0][index(i)].target == scene.reports[2][index(j)].target;
        if (same) sum += view.between(0, i, 2, j);
      }
    }
  }
  // Mean and standard deviation of chi-square with 2 degrees of freedom are both 2.
  const double pairs = 36.0 * kScenes;
  EXPECT_NEAR(sum / pairs, 2.0, 5.0 * 2.0 / std::sqrt(pairs));
}

TEST(SensorWindowTest, EqualityRowsAddAColumnForEveryReportAlone) {
  ScenarioSpec spec = some_point();
  const SensorScene scene = simulate_sensors(spec, kSeed, 1);
  const AssociationProblem packing = sensor_window(spec, scene).problem;
  spec.model.rows = RowRule::kEquality;
  const AssociationProblem equality = sensor_window(spec, scene).problem;
  EXPECT_EQ(equality.columns(), packing.columns() + packing.rows());
  EXPECT_TRUE(equality.shape().always_feasible);
  EXPECT_TRUE(equality.shape().has_exactly_once_rows);
}

/// A sensor that has seen nothing leaves pairs of the others.
TEST(SensorWindowTest, EmptySensorsAreNoTrouble) {
  const ScenarioSpec spec = some_point();
  SensorScene scene = simulate_sensors(spec, kSeed, 1);
  scene.reports[1].clear();
  WindowInstance window = sensor_window(spec, scene);
  attach_sensor_view(spec, scene, window);
  EXPECT_GT(window.problem.columns(), 0);
  for (int j = 0; j < window.problem.columns(); ++j) {
    EXPECT_EQ(window.problem.rows_of(j).size(), 2U);
  }
  scene.reports[0].clear();
  EXPECT_EQ(sensor_window(spec, scene).problem.columns(), 0);
  scene.reports[2].clear();
  EXPECT_EQ(sensor_window(spec, scene).problem.rows(), 0);
}

TEST(SensorWindowTest, TrueTuplesCostWhatTheirColumnsCost) {
  const ScenarioSpec spec = sensor_point(36, SensorLayout::kGrid, 0.1, 0.1);
  const SensorScene scene = simulate_sensors(spec, kSeed, 1);
  WindowInstance window = sensor_window(spec, scene);
  attach_sensor_view(spec, scene, window);
  double sum = 0.0;
  for (const auto& rows : true_tuples(scene)) {
    Tuple tuple{.rows = std::vector<int>(3, kNoRow)};
    for (const int row : rows) tuple.rows[index(window.problem.dimension(row) - 1)] = row;
    sum += window.problem.views()->tuple_cost(tuple);
  }
  EXPECT_NEAR(true_cost(spec, scene), sum, 1e-9);
}

}  // namespace
}  // namespace mda::testing
