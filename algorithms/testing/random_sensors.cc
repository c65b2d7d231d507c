#include "algorithms/testing/random_sensors.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "algorithms/testing/draw.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

struct Point {
  double x;
  double y;
};

using Points = std::array<std::vector<Point>, SensorView::kSensors>;

/// A sum of twelve uniform numbers: mean 0, variance 1.
double bell(Draw& draw) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += draw.unit();
  return sum;
}

Points random_points(Draw& draw) {
  constexpr double kSide = 8.0;
  constexpr std::size_t kMost = 6;
  Points points;
  std::vector<Point> targets;
  for (int t = draw.below(5); t > 0; --t) {
    targets.push_back({kSide * draw.unit(), kSide * draw.unit()});
  }
  for (auto& of_sensor : points) {
    for (const Point& target : targets) {
      if (draw.chance(0.7)) of_sensor.push_back({target.x + bell(draw), target.y + bell(draw)});
    }
    for (int n = draw.below(3); n > 0 && of_sensor.size() < kMost; --n) {
      of_sensor.push_back({kSide * draw.unit(), kSide * draw.unit()});
    }
  }
  return points;
}

/// The row of a report, or kNoRow.
using Rows = std::array<int, SensorView::kSensors>;

double cost_of_rows(const std::vector<double>& between, int count, const Rows& rows) {
  double sum = 0.0;
  int members = 0;
  for (std::size_t s = 0; s < rows.size(); ++s) {
    if (rows[s] == kNoRow) continue;
    ++members;
    for (std::size_t t = 0; t < s; ++t) {
      if (rows[t] != kNoRow) sum += between[index(rows[t] * count + rows[s])];
    }
  }
  if (members < 2) return 0.0;
  return members == 2 ? sum / 2.0 - 4.0 : sum / 3.0 - 9.0;
}

}  // namespace

AssociationProblem sensor_problem(const std::array<int, 3>& reports,
                                  const ReportDistance& distance) {
  auto views = std::make_shared<Views>();
  SensorView& view = views->sensors.emplace();
  ProblemBuilder builder;
  for (int s = 0; s < SensorView::kSensors; ++s) {
    for (int i = 0; i < reports[index(s)]; ++i) {
      view.row[index(s)].push_back(builder.add_row(s + 1, RowUse::kAtMostOnce));
    }
  }
  const int count = builder.rows();
  std::vector<double> between(index(count * count));  // of the rows of two reports
  for (int s = 0; s < SensorView::kSensors; ++s) {
    for (int t = s + 1; t < SensorView::kSensors; ++t) {
      for (int i = 0; i < view.reports(s); ++i) {
        for (int j = 0; j < view.reports(t); ++j) {
          const double a = distance(s, i, t, j);
          view.distance[index(s + t - 1)].push_back(a);
          between[index(view.row[index(s)][index(i)] * count + view.row[index(t)][index(j)])] = a;
        }
      }
    }
  }
  std::array<std::vector<int>, SensorView::kSensors> choices = view.row;
  for (auto& choice : choices) choice.push_back(kNoRow);
  for (const int a : choices[0]) {
    for (const int b : choices[1]) {
      for (const int c : choices[2]) {
        const double cost = cost_of_rows(between, count, {a, b, c});
        std::vector<int> rows = {a, b, c};
        std::erase(rows, kNoRow);
        if (cost < 0.0) builder.add_column(cost, rows);
      }
    }
  }
  builder.set_dimensions(SensorView::kSensors);
  views->tuple_cost = [between = std::move(between), count](const Tuple& tuple) {
    return cost_of_rows(between, count, {tuple.rows.at(0), tuple.rows.at(1), tuple.rows.at(2)});
  };
  AssociationProblem problem = builder.build();
  problem.attach(std::move(views));
  return problem;
}

AssociationProblem random_sensor_problem(std::uint64_t seed, std::uint64_t order) {
  Draw draw(seed);
  const Points points = random_points(draw);
  Draw shuffle(order);
  std::array<std::vector<int>, SensorView::kSensors> place;
  std::array<int, SensorView::kSensors> reports{};
  for (std::size_t s = 0; s < points.size(); ++s) {
    reports[s] = static_cast<int>(points[s].size());
    place[s] = shuffle.permutation(reports[s]);
    if (order == 0) std::iota(place[s].begin(), place[s].end(), 0);
  }
  const auto at = [&](int s, int i) { return points[index(s)][index(place[index(s)][index(i)])]; };
  return sensor_problem(reports, [&](int s, int i, int t, int j) {
    const Point a = at(s, i);
    const Point b = at(t, j);
    return ((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)) / 2.0;
  });
}

}  // namespace mda::testing
