// The loop around the windows: believing, moving, and what breaks it.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "scenarios/cartesian/position_windows.h"
#include "scenarios/groups.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

TEST(PositionWindowsLoopTest, ValuesOfColumnsAreBeliefs) {
  PositionWindows windows(*find_scenario("lee-parallel-c0.8"), 1, 1);
  while (windows.next()) {
    const AssociationProblem& problem = windows.window().problem;
    std::vector<double> x(index(problem.columns()), 0.0);
    const std::vector<Belief> truth = windows.true_beliefs();
    const PairView& pairs = *problem.views()->pairs;
    bool all_in_gate = true;
    for (int t = 0; t < windows.targets(); ++t) {
      for (const auto& [plot, probability] : truth[index(t)].items) {
        const int column = pairs.column[pairs.at(t, plot)];
        all_in_gate = all_in_gate && column != kNoColumn;
        if (column != kNoColumn) x[index(column)] = probability;
      }
      if (truth[index(t)].items.empty()) x[index(pairs.miss_column[index(t)])] = 1.0;
    }
    if (all_in_gate) {
      const std::vector<Belief> beliefs = windows.beliefs_of(x);
      for (int t = 0; t < windows.targets(); ++t) {
        ASSERT_EQ(beliefs[index(t)].items.size(), truth[index(t)].items.size());
        if (truth[index(t)].items.empty()) continue;
        EXPECT_EQ(beliefs[index(t)].items[0].plot, truth[index(t)].items[0].plot);
        EXPECT_EQ(beliefs[index(t)].items[0].probability, 1.0);
      }
    }
    windows.advance(truth);
  }
}

TEST(PositionWindowsLoopTest, WithoutTracksThereAreNoColumns) {
  PositionWindows windows(*find_scenario("lee-parallel-uniform"), 1, 1);
  while (windows.next()) windows.advance(std::vector<Belief>(2));
  EXPECT_TRUE(windows.is_dropped(0) && windows.is_dropped(1));
  const AssociationProblem& problem = windows.window().problem;
  EXPECT_EQ(problem.columns(), 0);
  EXPECT_EQ(problem.shape().dimensions, 2);
  EXPECT_GT(problem.rows(), 0);
  EXPECT_EQ(problem.views()->pairs->tracks(), 0);
}

TEST(PositionWindowsLoopTest, BadUseIsRefused) {
  ScenarioSpec spec = *find_scenario("lee-crossing");
  PositionWindows windows(spec, 1, 1);
  const std::vector<Belief> nothing(2);
  EXPECT_THROW(windows.advance(nothing), std::logic_error);
  ASSERT_TRUE(windows.next());
  EXPECT_THROW(static_cast<void>(windows.next()), std::logic_error);
  EXPECT_THROW(windows.advance(std::vector<Belief>(1)), std::invalid_argument);
  const auto in_plot = [](int plot, double probability) {
    return std::vector<Belief>{{.items = {{plot, probability}}}, {}};
  };
  EXPECT_THROW(windows.advance(in_plot(-1, 1.0)), std::invalid_argument);
  EXPECT_THROW(windows.advance(in_plot(99, 1.0)), std::invalid_argument);
  EXPECT_THROW(windows.advance(in_plot(0, -0.1)), std::invalid_argument);
  EXPECT_THROW(windows.advance(in_plot(0, std::nan(""))), std::invalid_argument);
  windows.advance(nothing);
  spec.world.detection_probability = 1.0;
  EXPECT_THROW(PositionWindows(spec, 1, 1), std::invalid_argument);
  EXPECT_THROW(PositionWindows(*find_scenario("A"), 1, 1), std::invalid_argument);
}

/// Without noise of any kind there is nothing to be unsure about, and no likelihood.
TEST(PositionWindowsLoopTest, ASingularCovarianceIsAnError) {
  ScenarioSpec spec = *find_scenario("lee-crossing");
  spec.position_targets->plot_sigma_km = 0.0;
  spec.world.acceleration_sigma_km_s2 = 0.0;
  PositionWindows windows(spec, 1, 1);
  EXPECT_THROW(static_cast<void>(windows.next()), std::runtime_error);
}

}  // namespace
}  // namespace mda::testing
