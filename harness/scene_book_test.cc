#include "harness/scene_book.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "harness/testing/recorded_run.h"
#include "harness/testing/temporary_directory.h"

namespace mda::testing {
namespace {

using nlohmann::json;

/// First scan, then a plot a scan.
using Track = std::vector<int>;

constexpr int kScans = 30;

/// The scenes of a run of the sweep.
std::vector<json> scenes_of(const Sweep& sweep) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = false;
  static_cast<void>(run_sweep(sweep, directory.path() / "run", 2, {}, interrupted));
  return lines_of(directory.path() / "run" / "scenes.jsonl");
}

Sweep two_algorithms() {
  Sweep sweep = small_sweep();
  sweep.algorithms = {"exact", "greedy", "lp"};
  return sweep;
}

const std::vector<json>& open_scenes() {
  static const std::vector<json> kScenes = scenes_of(two_algorithms());
  return kScenes;
}

/// Whether a track takes a plot that is there, once, in every one of its scans that it says so.
void expect_plots_there(const json& scene, const json& tracks) {
  std::set<std::pair<int, int>> taken;
  for (const Track track : tracks) {
    ASSERT_GE(track.size(), 2U);
    EXPECT_NE(track.at(1), kNoPlot);
    EXPECT_NE(track.back(), kNoPlot);
    for (std::size_t i = 1; i < track.size(); ++i) {
      if (track[i] == kNoPlot) continue;
      const int scan = track.front() + static_cast<int>(i) - 1;
      EXPECT_TRUE(taken.emplace(scan, track[i]).second) << "two tracks take it";
      EXPECT_LT(track[i], scene["plots"].at(static_cast<std::size_t>(scan - 1)).size());
    }
  }
}

TEST(SceneBookTest, EveryCellOfTheFirstReplicateHasItsScene) {
  Sweep sweep = two_algorithms();
  for (ScenarioPlan& plan : sweep.scenarios) plan.replicates = 2;
  std::set<std::pair<std::string, int>> cells;
  for (const json& scene : scenes_of(sweep)) {
    EXPECT_EQ(scene["replicate"], 1);
    EXPECT_EQ(scene["loop"], "open");
    EXPECT_TRUE(cells.emplace(scene["scenario"], scene["window_k"]).second);
  }
  EXPECT_EQ(cells, (std::set<std::pair<std::string, int>>{{"A", 3}, {"A", 5}, {"C", 3}}));
}

TEST(SceneBookTest, PlotsLieAtTheirTargets) {
  for (const json& scene : open_scenes()) {
    ASSERT_EQ(scene["plots"].size(), kScans);
    int of_targets = 0;
    for (std::size_t scan = 1; scan <= kScans; ++scan) {
      for (const json& plot : scene["plots"][scan - 1]) {
        EXPECT_LE(std::hypot(plot[0].get<double>(), plot[1].get<double>()),
                  scene["range_km"].get<double>() + 1.0);
        if (plot[2] == kFalseAlarm) continue;
        const json& target = scene["targets"].at(plot[2].get<std::size_t>());
        const json& position =
            target["positions_km"].at(scan - target["first_scan"].get<std::size_t>());
        const double x = plot[0].get<double>() - position[0].get<double>();
        const double y = plot[1].get<double>() - position[1].get<double>();
        EXPECT_LE(std::hypot(x, y), 1.0);
        ++of_targets;
      }
    }
    EXPECT_GT(of_targets, kScans);
  }
}

TEST(SceneBookTest, ASceneIsTheSameUnderEveryK) {
  std::map<int, json> by_k;
  for (const json& scene : open_scenes()) {
    if (scene["scenario"] == "A") by_k[scene["window_k"]] = scene;
  }
  for (const char* field : {"plots", "targets", "range_km"}) {
    EXPECT_EQ(by_k.at(3)[field], by_k.at(5)[field]) << field;
  }
}

TEST(SceneBookTest, EveryWindowHasTheTracksOfEveryChoice) {
  for (const json& scene : open_scenes()) {
    const int k = scene["window_k"];
    std::set<std::string> names;
    for (const json& answer : scene["answers"]) {
      names.insert(answer["algorithm"]);
      EXPECT_EQ(answer["window_k"], k);
      EXPECT_EQ(answer["loop"], "open");
      ASSERT_EQ(answer["scans"].size(), kScans);
      for (int scan = 1; scan <= kScans; ++scan) {
        const json& entry = answer["scans"][static_cast<std::size_t>(scan - 1)];
        EXPECT_EQ(entry["scan"], scan);
        expect_plots_there(scene, entry["tracks"]);
        const int oldest = scan <= k + 1 ? 1 : scan - k + 1;
        for (const Track track : entry["tracks"]) {
          EXPECT_GE(track.front(), oldest);
          EXPECT_LE(track.front() + std::ssize(track) - 2, scan);
        }
      }
    }
    EXPECT_EQ(names, (std::set<std::string>{"exact", "greedy"})) << "lp answers no choice";
  }
}

/// What is left of the tracks from a scan on, without misses before their first plot.
std::set<Track> from_scan(const json& tracks, int oldest) {
  std::set<Track> cut;
  for (const Track track : tracks) {
    auto first = static_cast<std::size_t>(std::max(0, oldest - track.front())) + 1;
    while (first < track.size() && track[first] == kNoPlot) ++first;
    if (first >= track.size()) continue;
    Track rest = {track.front() + static_cast<int>(first) - 1};
    rest.insert(rest.end(), track.begin() + static_cast<std::ptrdiff_t>(first), track.end());
    cut.insert(rest);
  }
  return cut;
}

/// The driver's own loop is the open loop: the last window is that of the whole tracks. The one is
/// read from the columns of the problem, the other from the hypotheses of the forest.
TEST(SceneBookTest, TheDriversWholeTracksEndInItsLastWindow) {
  Sweep sweep = two_algorithms();
  sweep.algorithms = {"exact"};
  for (ScenarioPlan& plan : sweep.scenarios) plan.closed_loop = true;
  const std::vector<json> closed = scenes_of(sweep);
  ASSERT_EQ(closed.size(), open_scenes().size());
  for (const json& scene : closed) {
    EXPECT_EQ(scene["loop"], "closed");
    const json& whole = scene["answers"].at(0)["scans"].at(0);
    EXPECT_EQ(whole["scan"], kScans);
    expect_plots_there(scene, whole["tracks"]);
    for (const json& open : open_scenes()) {
      if (cell_of(open) != cell_of(scene)) continue;
      const json& last = open["answers"].at(0)["scans"].back()["tracks"];
      const int oldest = kScans - scene["window_k"].get<int>() + 1;
      EXPECT_EQ(from_scan(whole["tracks"], oldest), from_scan(last, oldest));
      EXPECT_GT(whole["tracks"].size(), last.size());
    }
  }
}

TEST(SceneBookTest, OnlyScenariosWithBirthsHaveScenes) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = false;
  Sweep sweep = small_sweep();
  sweep.algorithms = {"greedy"};
  sweep.scenarios = {{scenario_named("static3-36-s0.10-f0.1"), {3}, 1}};
  static_cast<void>(run_sweep(sweep, directory.path() / "run", 1, {}, interrupted));
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "run" / "scenes.jsonl"));
}

}  // namespace
}  // namespace mda::testing
