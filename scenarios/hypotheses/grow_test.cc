// What holds of the forest's layers by themselves, and scenes at the edge of what can be grown.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/groups.h"
#include "scenarios/testing/choices.h"
#include "scenarios/testing/lock_step.h"
#include "scenarios/world/simulate.h"

namespace mda::testing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kSeed = 1;

/// Children are neighbours in the order of their parents, each parent's in the order of their plots
/// with the miss last; then one birth for each plot.
void expect_ordered_layer(const TrackForest& forest, int scan) {
  const auto nodes = forest.nodes(scan);
  const bool oldest = scan == 1 || scan == forest.fixed_scan();
  const int parents = oldest ? 0 : static_cast<int>(forest.nodes(scan - 1).size());
  const int births_begin = static_cast<int>(nodes.size()) - forest.plots(scan);
  ASSERT_GE(births_begin, 0);
  const auto last_if_miss = [&](int plot) { return plot == kNoPlot ? forest.plots(scan) : plot; };
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    const Node& node = nodes[static_cast<std::size_t>(i)];
    if (i >= births_begin) {
      EXPECT_EQ(node.parent, kNoParent);
      EXPECT_EQ(node.plot, i - births_begin);
      continue;
    }
    EXPECT_GE(node.parent, 0);
    EXPECT_LT(node.parent, parents);
    EXPECT_LT(node.plot, forest.plots(scan));
    if (i == 0) continue;
    const Node& before = nodes[static_cast<std::size_t>(i) - 1];
    EXPECT_LE(before.parent, node.parent);
    if (before.parent == node.parent) {
      EXPECT_LT(last_if_miss(before.plot), last_if_miss(node.plot));
    }
  }
}

void expect_leaves_agree(const TrackForest& forest, const Histories& histories) {
  ASSERT_EQ(forest.leaves().size(), forest.nodes(forest.newest_scan()).size());
  for (int i = 0; i < static_cast<int>(forest.leaves().size()); ++i) {
    const Leaf& leaf = forest.leaves()[static_cast<std::size_t>(i)];
    const History history = histories.of_leaf(forest, i);
    ASSERT_FALSE(history.empty());
    EXPECT_TRUE(std::isfinite(leaf.cost));
    EXPECT_EQ(leaf.birth_scan, history.front().scan);
    EXPECT_EQ(leaf.first_plot, history.front().plot);
    EXPECT_EQ(leaf.plots, std::min<std::size_t>(history.size(), 3));
    if (leaf.misses == kEnded) {
      EXPECT_EQ(leaf.source, history.back().scan + forest.model().max_misses + 1);
      EXPECT_LT(forest.column_cost(leaf), 0.0);
    } else {
      EXPECT_EQ(leaf.misses, forest.newest_scan() - history.back().scan);
    }
  }
}

void expect_lawful(const TrackForest& forest, const Histories& histories) {
  for (int scan = forest.fixed_scan() + 1; scan <= forest.newest_scan(); ++scan) {
    SCOPED_TRACE("layer of scan " + std::to_string(scan));
    expect_ordered_layer(forest, scan);
  }
  if (forest.newest_scan() > forest.fixed_scan()) expect_leaves_agree(forest, histories);
}

TEST(GrowTest, LayersStayInOrder) {
  for (const char* group : {"A", "C", "D"}) {
    for (const int window_k : {1, 2, 3, 6}) {
      const ScenarioSpec& spec = *find_scenario(group);
      TrackForest forest;
      WindowExtractor extractor;
      Histories histories;
      forest.reset(spec.world, spec.model, window_k);
      for (const Scan& scan : simulate(spec, kSeed, 2).scans) {
        SCOPED_TRACE(spec.name + ", K = " + std::to_string(window_k) + ", scan " +
                     std::to_string(forest.newest_scan() + 1));
        forest.grow(scan);
        expect_lawful(forest, histories);
        const WindowInstance window = extractor.extract(forest);
        const std::vector<int> chosen = leaves_of(window, cheapest_that_fit(window.problem));
        histories.before_decision(forest, chosen);
        forest.decide(chosen);
        expect_lawful(forest, histories);
        ASSERT_FALSE(::testing::Test::HasFailure());
      }
    }
  }
}

/// Everything that the forest shows, number by number.
std::vector<double> numbers_of(const TrackForest& forest) {
  std::vector<double> numbers = {forest.retired_cost(), static_cast<double>(forest.hypotheses()),
                                 static_cast<double>(forest.tracks())};
  for (const Leaf& leaf : forest.leaves()) {
    numbers.insert(numbers.end(),
                   {leaf.cost, double(leaf.source), double(leaf.first_plot),
                    double(leaf.birth_scan), double(leaf.plots), double(leaf.misses)});
  }
  for (int scan = forest.fixed_scan() + 1; scan <= forest.newest_scan(); ++scan) {
    for (const Node& node : forest.nodes(scan)) {
      numbers.insert(numbers.end(), {double(node.parent), double(node.plot)});
    }
  }
  return numbers;
}

std::vector<double> play(TrackForest& forest, const ScenarioSpec& spec, int window_k) {
  WindowExtractor extractor;
  std::vector<double> seen;
  forest.reset(spec.world, spec.model, window_k);
  for (const Scan& scan : simulate(spec, kSeed, 1).scans) {
    forest.grow(scan);
    const std::vector<double> numbers = numbers_of(forest);
    seen.insert(seen.end(), numbers.begin(), numbers.end());
    const WindowInstance window = extractor.extract(forest);
    forest.decide(leaves_of(window, cheapest_that_fit(window.problem)));
  }
  return seen;
}

/// A forest keeps memory, never information: also after a wider window of more misses.
TEST(GrowTest, ResetAndReplayGivesTheSameBits) {
  const ScenarioSpec& narrow = *find_scenario("B");
  ScenarioSpec wide = *find_scenario("D");
  wide.model.max_misses = 4;
  TrackForest fresh;
  const std::vector<double> expected = play(fresh, narrow, 3);
  TrackForest used;
  const std::vector<double> of_wide = play(used, wide, 5);
  EXPECT_EQ(play(used, narrow, 3), expected);
  EXPECT_EQ(play(used, narrow, 3), expected);
  EXPECT_EQ(play(fresh, wide, 5), of_wide);
}

TEST(GrowTest, CountsWhatItMakes) {
  const ScenarioSpec& spec = *find_scenario("A");
  Plot plot;
  plot.range_km = 10.0;
  Plot far = plot;
  far.range_km = 40.0;
  TrackForest forest;
  forest.reset(spec.world, spec.model, 3);
  forest.grow(Scan{{plot, far}, {}});
  EXPECT_EQ(forest.hypotheses(), 2);  // two births
  forest.grow(Scan{{plot}, {}});
  EXPECT_EQ(forest.hypotheses(), 2 + 1 + 2 + 1);  // a pair, two misses, a birth
}

/// Plays handmade scans through both forests with the cheapest choice.
Tally play_by_hand(const ScenarioSpec& spec, int window_k, const std::vector<Scan>& scans) {
  LockStep game(spec, window_k);
  for (const Scan& scan : scans) {
    EXPECT_EQ(game.grow(scan), "") << "scan " << game.forest().newest_scan();
    expect_leaves_agree(game.forest(), game.histories());
    EXPECT_EQ(game.decide(cheapest_that_fit(game.window().problem)), "");
  }
  return game.tally();
}

/// What the radar sees of a target in straight motion if it never misses and never errs.
std::vector<Scan> straight_track(TargetState state, const World& world, int scans) {
  std::vector<Scan> seen;
  for (int i = 0; i < scans; ++i) {
    Plot plot;
    plot.range_km = std::hypot(state.x, state.y);
    plot.bearing_rad = std::atan2(state.y, state.x);
    plot.source = 0;
    seen.push_back({{plot}, {{0, state}}});
    state.x += world.scan_period_s * state.vx;
    state.y += world.scan_period_s * state.vy;
  }
  return seen;
}

/// Plots of the cheapest column of the newest window.
std::size_t plots_of_best_track(const ScenarioSpec& spec, const std::vector<Scan>& scans) {
  LockStep game(spec, 4);
  std::size_t plots = 0;
  for (const Scan& scan : scans) {
    EXPECT_EQ(game.grow(scan), "");
    const std::vector<int> best = cheapest_that_fit(game.window().problem);
    plots = best.empty()
                ? 0
                : game.histories().of_column(game.forest(), game.window().problem, best[0]).size();
    EXPECT_EQ(game.decide(best), "");
  }
  return plots;
}

TEST(GrowTest, EmptyScans) {
  const ScenarioSpec& spec = *find_scenario("B");
  std::vector<Scan> scans = simulate(spec, kSeed, 3).scans;
  for (const std::size_t empty : {0, 1, 5, 6, 12, 13, 14, 15, 16, 20}) scans[empty].plots.clear();
  for (const int window_k : {1, 2, 4}) {
    EXPECT_GT(play_by_hand(spec, window_k, scans).columns, window_k == 1 ? -1 : 0);
  }
  for (Scan& scan : scans) scan.plots.clear();
  EXPECT_EQ(play_by_hand(spec, 3, scans).columns, 0);
}

TEST(GrowTest, OnePlotPerScan) {
  const ScenarioSpec& spec = *find_scenario("A");
  const std::vector<Scan> scans = straight_track({-20.0, 0.3, 12.0, 0.1}, spec.world, 12);
  EXPECT_EQ(plots_of_best_track(spec, scans), scans.size());
  std::vector<Scan> single(5);
  single[2] = scans[2];
  EXPECT_EQ(play_by_hand(spec, 2, single).columns, 0);
}

TEST(GrowTest, CrossesTheCutOfTheBearing) {
  const ScenarioSpec& spec = *find_scenario("A");
  for (const double vy : {0.25, -0.25}) {
    const TargetState start{-30.0, 0.05, -10.0 * vy * spec.world.scan_period_s / 2.0, vy};
    const std::vector<Scan> scans = straight_track(start, spec.world, 12);
    EXPECT_LT(scans.front().plots[0].bearing_rad * scans.back().plots[0].bearing_rad, 0.0);
    EXPECT_EQ(plots_of_best_track(spec, scans), scans.size());
  }
}

/// All plots lie within a few hundredths of the cut, from both sides of it.
TEST(GrowTest, ClutterOnTheCutOfTheBearing) {
  const ScenarioSpec& spec = *find_scenario("C");
  std::vector<Scan> scans = simulate(spec, kSeed, 1).scans;
  scans.resize(12);
  for (Scan& scan : scans) {
    for (Plot& plot : scan.plots) {
      plot.bearing_rad = std::remainder(kPi + 0.02 * plot.bearing_rad, 2.0 * kPi);
    }
  }
  EXPECT_GT(play_by_hand(spec, 3, scans).long_columns, 100);
}

/// A target passes right over the radar, where bearing and Jacobian are undefined.
TEST(GrowTest, OverTheRadar) {
  const ScenarioSpec& spec = *find_scenario("A");
  for (const double miss_distance_km : {0.0, 1e-12, 1e-6, 1e-3, 0.1}) {
    const TargetState start{-4.0 * spec.world.scan_period_s * 0.25, 0.25, miss_distance_km, 0.0};
    TrackForest forest;
    WindowExtractor extractor;
    Histories histories;
    forest.reset(spec.world, spec.model, 3);
    for (const Scan& scan : straight_track(start, spec.world, 9)) {
      forest.grow(scan);
      expect_leaves_agree(forest, histories);  // costs are finite
      const WindowInstance window = extractor.extract(forest);
      const std::vector<int> chosen = leaves_of(window, cheapest_that_fit(window.problem));
      EXPECT_EQ(chosen.empty(), forest.newest_scan() < 2);
      histories.before_decision(forest, chosen);
      forest.decide(chosen);
    }
  }
}

}  // namespace
}  // namespace mda::testing
