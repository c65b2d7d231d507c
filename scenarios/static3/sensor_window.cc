#include "scenarios/static3/sensor_window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "scenarios/static3/report_grid.h"
#include "scenarios/static3/tuple_cost.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Rows are numbered sensor by sensor.
int first_row(const SensorScene& scene, int sensor) {
  int row = 0;
  for (int s = 0; s < sensor; ++s) row += static_cast<int>(scene.reports[index(s)].size());
  return row;
}

class Maker {
 public:
  Maker(const ScenarioSpec& spec, const SensorScene& scene)
      : scene_(scene),
        equality_(spec.model.rows == RowRule::kEquality),
        costs_(spec),
        gate_(std::min(spec.model.gate, std::max(costs_.widest(2), costs_.widest(3)))),
        radius_(spec.three_sensors->sigma_per_spacing * std::sqrt(2.0 * std::max(0.0, gate_))) {
    for (int s = 0; s < kSensors; ++s) {
      first_row_[index(s)] = first_row(scene, s);
      for (std::size_t i = 0; i < scene.reports[index(s)].size(); ++i) {
        builder_.add_row(s + 1, equality_ ? RowUse::kExactlyOnce : RowUse::kAtMostOnce);
      }
    }
    builder_.set_dimensions(kSensors);
  }

  AssociationProblem make() {
    if (gate_ > 0.0) {
      const Near second = near(0, 1);
      const Near third = near(0, 2);
      const Near third_of_second = near(1, 2);
      for (int i = 0; i < std::ssize(second); ++i) {
        add_first(i, second[index(i)], third[index(i)], third_of_second);
      }
      for (int j = 0; j < std::ssize(third_of_second); ++j) {
        for (const int k : third_of_second[index(j)]) add({kNone, j, k});
      }
    }
    for (int row = 0; equality_ && row < builder_.rows(); ++row) {
      builder_.add_column(0.0, std::span(&row, 1));
    }
    return builder_.build();
  }

 private:
  static constexpr int kNone = -1;
  /// Per report of one sensor, those of another in its gate, ascending.
  using Near = std::vector<std::vector<int>>;

  Near near(int sensor, int other) const {
    const auto& reports = scene_.reports[index(sensor)];
    const auto& others = scene_.reports[index(other)];
    const ReportGrid grid(others, scene_.side, radius_);
    Near result(reports.size());
    for (std::size_t i = 0; i < reports.size(); ++i) {
      grid.visit_near(reports[i], [&](int j) {
        if (costs_.distance(reports[i], others[index(j)]) <= gate_) result[i].push_back(j);
      });
      std::sort(result[i].begin(), result[i].end());
    }
    return result;
  }

  /// All that report i of the first sensor is in.
  void add_first(int i, const std::vector<int>& second, const std::vector<int>& third,
                 const Near& third_of_second) {
    std::vector<int> both;
    for (const int j : second) {
      add({i, j, kNone});
      both.clear();
      const auto& of_second = third_of_second[index(j)];
      std::set_intersection(third.begin(), third.end(), of_second.begin(), of_second.end(),
                            std::back_inserter(both));
      for (const int k : both) add({i, j, k});
    }
    for (const int k : third) add({i, kNone, k});
  }

  /// Adds the tuple if its cost is negative.
  void add(const std::array<int, kSensors>& tuple) {
    std::vector<const SensorReport*> reports;
    std::vector<int> rows;
    for (int s = 0; s < kSensors; ++s) {
      const int i = tuple[index(s)];
      if (i == kNone) continue;
      reports.push_back(&scene_.reports[index(s)][index(i)]);
      rows.push_back(first_row_[index(s)] + i);
    }
    const double cost = costs_.column(reports);
    if (cost >= 0.0) return;
    if (builder_.columns() == kMostSensorColumns) {
      throw std::runtime_error("more than " + std::to_string(kMostSensorColumns) +
                               " tuples are in the gates");
    }
    builder_.add_column(cost, rows);
  }

  const SensorScene& scene_;
  bool equality_;
  SensorCosts costs_;
  double gate_;
  double radius_;
  std::array<int, kSensors> first_row_{};
  ProblemBuilder builder_;
};

/// Of tuples whose rows are those of the scene.
TupleCost tuple_cost(const ScenarioSpec& spec, const SensorScene& scene) {
  std::vector<SensorReport> reports;
  for (const auto& of_sensor : scene.reports) {
    reports.insert(reports.end(), of_sensor.begin(), of_sensor.end());
  }
  return [costs = SensorCosts(spec), reports = std::move(reports)](const Tuple& tuple) {
    std::vector<const SensorReport*> members;
    for (const int row : tuple.rows) {
      if (row != kNoRow) members.push_back(&reports[index(row)]);
    }
    return costs.column(members);
  };
}

}  // namespace

WindowInstance sensor_window(const ScenarioSpec& spec, const SensorScene& scene) {
  if (const std::string fault = sensor_fault(spec); !fault.empty()) {
    throw std::invalid_argument(fault);
  }
  WindowInstance window;
  window.problem = Maker(spec, scene).make();
  const auto n = [&](int s) { return static_cast<double>(scene.reports[index(s)].size()); };
  window.ungated_columns = (n(0) + 1.0) * (n(1) + 1.0) * (n(2) + 1.0) - n(0) - n(1) - n(2) - 1.0;
  return window;
}

void attach_sensor_view(const ScenarioSpec& spec, const SensorScene& scene,
                        WindowInstance& window) {
  const SensorCosts costs(spec);
  auto views = std::make_shared<Views>();
  views->tuple_cost = tuple_cost(spec, scene);
  SensorView& sensors = views->sensors.emplace();
  for (int s = 0; s < kSensors; ++s) {
    for (int i = 0; i < std::ssize(scene.reports[index(s)]); ++i) {
      sensors.row[index(s)].push_back(first_row(scene, s) + i);
    }
    for (int t = s + 1; t < kSensors; ++t) {
      for (const SensorReport& report : scene.reports[index(s)]) {
        for (const SensorReport& other : scene.reports[index(t)]) {
          sensors.distance[index(s + t - 1)].push_back(costs.distance(report, other));
        }
      }
    }
  }
  window.problem.attach(std::move(views));
}

std::vector<std::vector<int>> true_tuples(const SensorScene& scene) {
  std::map<int, std::vector<int>> rows_of_target;
  int row = 0;
  for (const auto& reports : scene.reports) {
    for (const SensorReport& report : reports) {
      if (report.target != kNoTarget) rows_of_target[report.target].push_back(row);
      ++row;
    }
  }
  std::vector<std::vector<int>> tuples;
  for (auto& [target, rows] : rows_of_target) {
    if (rows.size() >= 2) tuples.push_back(std::move(rows));
  }
  return tuples;
}

double true_cost(const ScenarioSpec& spec, const SensorScene& scene) {
  const TupleCost cost = tuple_cost(spec, scene);
  double sum = 0.0;
  for (std::vector<int>& rows : true_tuples(scene)) sum += cost({.rows = std::move(rows)});
  return sum;
}

}  // namespace mda
