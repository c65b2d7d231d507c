#include "scenarios/cartesian/position_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "algorithms/testing/tree_laws.h"
#include "scenarios/groups.h"
#include "scenarios/testing/positions.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// A filter of constant velocity on (x, vx, y, vy) for a scan period of 1 s, written out plainly.
class PlainFilter {
 public:
  PlainFilter(const ScenarioSpec& spec, const FirstLooks& looks)
      : r_(std::pow(spec.position_targets->plot_sigma_km, 2)),
        q_(std::pow(spec.world.acceleration_sigma_km_s2, 2)) {
    const Eigen::Vector2d velocity = looks.now - looks.before;
    mean_ << looks.now.x(), velocity.x(), looks.now.y(), velocity.y();
    covariance_ << r_, r_, 0, 0, r_, 2 * r_, 0, 0, 0, 0, r_, r_, 0, 0, r_, 2 * r_;
  }

  void predict() {
    Eigen::Matrix4d f;
    f << 1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1;
    Eigen::Matrix<double, 4, 2> g;
    g << 0.5, 0, 1, 0, 0, 0.5, 0, 1;
    mean_ = f * mean_;
    covariance_ = f * covariance_ * f.transpose() + q_ * g * g.transpose();
  }

  void take(const Eigen::Vector2d& plot) {
    const Eigen::Matrix<double, 4, 2> gain =
        covariance_ * h().transpose() * innovation_covariance().inverse();
    mean_ += gain * (plot - h() * mean_);
    covariance_ = (Eigen::Matrix4d::Identity() - gain * h()) * covariance_;
  }

  [[nodiscard]] double distance(const Eigen::Vector2d& plot) const {
    const Eigen::Vector2d nu = plot - h() * mean_;
    return nu.dot(innovation_covariance().inverse() * nu);
  }
  [[nodiscard]] double density(const Eigen::Vector2d& plot) const {
    return std::exp(-0.5 * distance(plot)) /
           (2.0 * std::numbers::pi * std::sqrt(innovation_covariance().determinant()));
  }

 private:
  static Eigen::Matrix<double, 2, 4> h() {
    Eigen::Matrix<double, 2, 4> h;
    h << 1, 0, 0, 0, 0, 0, 1, 0;
    return h;
  }
  [[nodiscard]] Eigen::Matrix2d innovation_covariance() const {
    return h() * covariance_ * h().transpose() + r_ * Eigen::Matrix2d::Identity();
  }

  double r_;
  double q_;
  Eigen::Vector4d mean_;
  Eigen::Matrix4d covariance_;
};

/// That the tracker reckons with.
double density_in(const ScenarioSpec& spec, int scan) {
  return scan <= 5 ? kLeastClutterPerKm2 : spec.position_targets->clutter_per_km2;
}

/// What the column of a track and a plot (or none) costs by the definition.
void expect_costs(const ScenarioSpec& spec, const PositionWindows& windows,
                  const std::vector<PlainFilter>& filters) {
  const AssociationProblem& problem = windows.window().problem;
  const auto& plots = windows.scan().plots;
  const double lambda = density_in(spec, windows.newest_scan());
  int column = 0;
  for (int track = 0; track < std::ssize(filters); ++track) {
    for (int plot = 0; plot < std::ssize(plots); ++plot) {
      const Eigen::Vector2d& at = plots[index(plot)].position;
      if (filters[index(track)].distance(at) > 9.21) continue;
      ASSERT_LT(column, problem.columns());
      const auto rows = problem.rows_of(column);
      ASSERT_EQ(rows.size(), 2U);
      EXPECT_EQ(rows[0], track);
      EXPECT_EQ(rows[1], static_cast<int>(filters.size()) + plot);
      EXPECT_NEAR(problem.cost(column), -std::log(0.7 * filters[index(track)].density(at) / lambda),
                  1e-7);
      ++column;
    }
    ASSERT_LT(column, problem.columns());
    ASSERT_EQ(problem.rows_of(column).size(), 1U);
    EXPECT_EQ(problem.rows_of(column)[0], track);
    EXPECT_NEAR(problem.cost(column), -std::log(1.0 - 0.7 * (1.0 - std::exp(-9.21 / 2.0))), 1e-12);
    ++column;
  }
  EXPECT_EQ(column, problem.columns());
}

TEST(PositionWindowsTest, ColumnsAreAllGatedPairsAndMissesAtTheirCost) {
  for (const char* name : {"lee-crossing", "lee-parallel-c0.8", "lee-crossing-uniform-c0.4"}) {
    SCOPED_TRACE(name);
    const ScenarioSpec& spec = *find_scenario(name);
    std::vector<PlainFilter> filters;
    for (const FirstLooks& looks : simulate_positions(spec, 1, 3).looks) {
      filters.emplace_back(spec, looks);
    }
    play_true_positions(spec, 3, [&](const PositionWindows& windows) {
      for (PlainFilter& filter : filters) filter.predict();
      expect_costs(spec, windows, filters);
      const PositionScan& scan = windows.scan();
      for (std::size_t i = 0; i < filters.size(); ++i) {
        if (scan.detected[i]) filters[i].take(scan.own[i]);
      }
    });
  }
}

TEST(PositionWindowsTest, TreesAndShapesObeyTheirLaws) {
  for (const ScenarioSpec& spec : position_scenarios()) {
    SCOPED_TRACE(spec.name);
    int seen = 0;
    play_true_positions(spec, 1, [&](const PositionWindows& windows) {
      ASSERT_EQ(windows.newest_scan(), ++seen);
      const AssociationProblem& problem = windows.window().problem;
      expect_lawful_tree(problem);
      expect_tuple_cost_of_columns(problem, 1e-9);
      const Shape& shape = problem.shape();
      EXPECT_EQ(shape.dimensions, 2);
      EXPECT_TRUE(shape.known_tracks && shape.always_feasible && shape.has_tree && shape.has_pairs);
      const auto plots = static_cast<int>(windows.scan().plots.size());
      EXPECT_EQ(shape.rows, windows.targets() + plots);
      EXPECT_EQ(windows.window().ungated_columns, windows.targets() * (plots + 1.0));
      for (int row = 0; row < shape.rows; ++row) {
        EXPECT_EQ(problem.use(row),
                  row < windows.targets() ? RowUse::kExactlyOnce : RowUse::kAtMostOnce);
      }
    });
    EXPECT_EQ(seen, 40);
  }
}

/// Column, gate, distance and likelihood of every pair say the same.
void expect_lawful_pairs(const AssociationProblem& problem) {
  const PairView& pairs = *problem.views()->pairs;
  ASSERT_EQ(pairs.tracks() + pairs.plots(), problem.rows());
  for (int t = 0; t < pairs.tracks(); ++t) {
    const int missed = pairs.miss_column[index(t)];
    EXPECT_EQ(problem.rows_of(missed).size(), 1U);
    EXPECT_EQ(problem.rows_of(missed)[0], pairs.track_row[index(t)]);
    EXPECT_NEAR(problem.cost(missed),
                -std::log(1.0 - pairs.detection_probability * pairs.gate_probability), 1e-12);
    for (int j = 0; j < pairs.plots(); ++j) {
      const std::size_t pair = pairs.at(t, j);
      const int column = pairs.column[pair];
      EXPECT_EQ(column != kNoColumn, pairs.distance[pair] <= pairs.gate);
      EXPECT_GE(pairs.distance[pair], 0.0);
      // One S per track: the peak is the same for all its plots.
      EXPECT_NEAR(pairs.log_likelihood[pair] + 0.5 * pairs.distance[pair],
                  pairs.log_likelihood[pairs.at(t, 0)] + 0.5 * pairs.distance[pairs.at(t, 0)],
                  1e-6 + 1e-12 * pairs.distance[pair]);
      if (column == kNoColumn) continue;
      EXPECT_EQ(problem.rows_of(column)[0], pairs.track_row[index(t)]);
      EXPECT_EQ(problem.rows_of(column)[1], pairs.plot_row[index(j)]);
      const double ratio = pairs.detection_probability / pairs.clutter_density;
      EXPECT_NEAR(problem.cost(column), -std::log(ratio) - pairs.log_likelihood[pair], 1e-9);
    }
  }
}

TEST(PositionWindowsTest, PairsObeyTheirLaws) {
  for (const ScenarioSpec& spec : position_scenarios()) {
    SCOPED_TRACE(spec.name);
    play_true_positions(spec, 2, [&](const PositionWindows& windows) {
      const AssociationProblem& problem = windows.window().problem;
      expect_lawful_pairs(problem);
      const PairView& pairs = *problem.views()->pairs;
      EXPECT_EQ(pairs.clutter_density, density_in(spec, windows.newest_scan()));
      EXPECT_EQ(pairs.gate, 9.21);
      EXPECT_NEAR(pairs.gate_probability, 0.99, 1e-4);
    });
  }
}

/// What is off the line, and what is along it, make up the whole.
TEST(PositionWindowsTest, LineDistanceIsAcrossThePredictedStep) {
  const ScenarioSpec& spec = *find_scenario("lee-parallel-uniform");
  play_true_positions(spec, 2, [&](const PositionWindows& windows) {
    const PairView& pairs = *windows.window().problem.views()->pairs;
    for (int t = 0; t < pairs.tracks(); ++t) {
      const TargetState at = state_of(windows.predicted()[index(t)]);
      const Eigen::Vector2d along = Eigen::Vector2d(at.vx, at.vy).normalized();
      for (int j = 0; j < pairs.plots(); ++j) {
        const Eigen::Vector2d off =
            windows.scan().plots[index(j)].position - Eigen::Vector2d(at.x, at.y);
        const double rest = off.squaredNorm() - std::pow(off.dot(along), 2);
        EXPECT_NEAR(pairs.line_distance[pairs.at(t, j)], rest, 1e-9 * (1.0 + off.squaredNorm()));
      }
    }
  });
}

/// The gate holds 99 % of the plots of a target whose track is right, more where the filter allows
/// for accelerations that there are not.
TEST(PositionWindowsTest, TrueTracksKeepTheirPlotsInTheGate) {
  for (const char* name : {"lee-crossing", "lee-parallel", "lee-ten"}) {
    SCOPED_TRACE(name);
    double plots = 0.0;
    double held = 0.0;
    for (int replicate = 1; replicate <= 20; ++replicate) {
      play_true_positions(*find_scenario(name), replicate, [&](const PositionWindows& windows) {
        const PairView& pairs = *windows.window().problem.views()->pairs;
        const std::vector<Belief> truth = windows.true_beliefs();
        for (int t = 0; t < windows.targets(); ++t) {
          for (const auto& [plot, probability] : truth[index(t)].items) {
            plots += 1.0;
            held += pairs.column[pairs.at(t, plot)] != kNoColumn ? 1.0 : 0.0;
          }
        }
      });
    }
    EXPECT_GE(held / plots, 0.99 - 5.0 * std::sqrt(0.99 * 0.01 / plots));
    EXPECT_LT(held, plots) << "no plot ever fell out of the gate";
  }
}

/// A track that misses for ever is dropped, coasts, and leaves the others alone.
TEST(PositionWindowsTest, ALostTrackLeavesTheWindows) {
  const ScenarioSpec& spec = *find_scenario("lee-crossing");
  std::vector<MotionEstimate> undisturbed;
  play_true_positions(spec, 1, [&](const auto& windows) { undisturbed = windows.predicted(); });
  PositionWindows windows(spec, 1, 1);
  int without = 0;
  MotionEstimate before;
  while (windows.next()) {
    const AssociationProblem& problem = windows.window().problem;
    expect_lawful_tree(problem);
    expect_lawful_pairs(problem);
    const bool dropped = windows.is_dropped(0);
    EXPECT_EQ(problem.views()->pairs->tracks(), dropped ? 1 : 2);
    EXPECT_EQ(windows.target_of_row(0), dropped ? 1 : 0);
    if (dropped) {
      ++without;
      EXPECT_NEAR(state_of(windows.predicted()[0]).x, state_of(before).x + state_of(before).vx,
                  1e-9);
    }
    std::vector<Belief> beliefs = windows.true_beliefs();
    if (!dropped) beliefs[0].items.clear();
    windows.advance(beliefs);
    before = windows.estimates()[0];
    EXPECT_FALSE(windows.is_dropped(1));
  }
  EXPECT_GT(without, 5);
  EXPECT_EQ(windows.predicted()[1].mean, undisturbed[1].mean);
}

TEST(PositionWindowsTest, WithoutClutterCostsAreFinite) {
  ScenarioSpec spec = *find_scenario("lee-crossing");
  spec.position_targets->clutter_per_km2 = 0.0;
  play_true_positions(spec, 1, [](const PositionWindows& windows) {
    for (const double cost : windows.window().problem.costs()) EXPECT_TRUE(std::isfinite(cost));
    EXPECT_EQ(windows.window().problem.views()->pairs->clutter_density, kLeastClutterPerKm2);
  });
}

}  // namespace
}  // namespace mda::testing
