#include "harness/track_metrics.h"

#include <gtest/gtest.h>

namespace mda {
namespace {

constexpr int kClutter = kFalseAlarm;

/// A scene whose scan s has plots of the sources in sources[s - 1]; every target named is in the
/// coverage in the last scan.
Scene scene_of(const std::vector<std::vector<int>>& sources, int targets) {
  Scene scene;
  scene.targets = targets;
  for (const auto& scan_sources : sources) {
    Scan& scan = scene.scans.emplace_back();
    for (const int source : scan_sources) scan.plots.push_back({1.0, 0.0, source});
  }
  for (int t = 0; t < targets; ++t) scene.scans.back().truth.push_back({t, {1.0, 0.0, 1.0, 0.0}});
  return scene;
}

/// The track that has plot number plots[s - 1] in scan s, or misses it where that is -1.
RecordedTrack track_of(const std::vector<int>& plots, bool alive = true) {
  RecordedTrack track;
  track.alive = alive;
  for (std::size_t s = 0; s < plots.size(); ++s) {
    if (plots[s] >= 0) track.plots.push_back({static_cast<int>(s) + 1, plots[s]});
  }
  return track;
}

TEST(TrackMetricsTest, PerfectTracksHaveNothingToBlame) {
  const Scene scene = scene_of({{0, 1}, {0, 1}, {0, 1}, {0, 1, kClutter}}, 2);
  const std::vector<RecordedTrack> tracks = {track_of({0, 0, 0, 0}), track_of({1, 1, 1, 1})};
  const TrackMetrics m = track_metrics(World{}, scene, tracks);
  EXPECT_EQ(m.tracks, 2);
  EXPECT_EQ(m.targets, 2);
  EXPECT_EQ(m.correct_association, 1.0);
  EXPECT_EQ(m.purity, 1.0);
  EXPECT_EQ(m.completeness, 1.0);
  EXPECT_EQ(m.track_breaks + m.swaps + m.lost, 0);
  EXPECT_EQ(m.present, 2);
}

TEST(TrackMetricsTest, CountsByHand) {
  // Target 0 is followed by two tracks (a break); the second one has a plot of target 1 in scan 6
  // (two swaps: there and back). Target 1 has a dead track; target 2 has two plots only.
  const Scene scene = scene_of({{0, 1, 2}, {0, 1, 2}, {0, 1}, {0, 1}, {0}, {0, 1}, {0}}, 3);
  const std::vector<RecordedTrack> tracks = {
      track_of({0, 0, 0}, false), track_of({-1, -1, -1, 0, 0, 1, 0}), track_of({1, 1, 1, 1}, false),
      track_of({2, 2})};  // too short to count
  const TrackMetrics m = track_metrics(World{}, scene, tracks);
  EXPECT_EQ(m.tracks, 3);
  EXPECT_EQ(m.targets, 2);
  EXPECT_DOUBLE_EQ(m.correct_association, (3.0 + 3.0 + 4.0) / 11.0);
  EXPECT_DOUBLE_EQ(m.purity, (1.0 + 0.75 + 1.0) / 3.0);
  EXPECT_DOUBLE_EQ(m.completeness, (6.0 + 4.0) / (7.0 + 5.0));
  EXPECT_EQ(m.track_breaks, 1);
  EXPECT_EQ(m.swaps, 2);
  EXPECT_EQ(m.present, 2);
  EXPECT_EQ(m.lost, 1);
}

TEST(TrackMetricsTest, ATrackOfClutterIsWrongAltogether) {
  const Scene scene = scene_of({{kClutter, 0}, {kClutter, 0}, {kClutter, 0}}, 1);
  const std::vector<RecordedTrack> tracks = {track_of({0, 0, 0})};
  const TrackMetrics m = track_metrics(World{}, scene, tracks);
  EXPECT_EQ(m.tracks, 1);
  EXPECT_EQ(m.correct_association, 0.0);
  EXPECT_EQ(m.purity, 1.0);
  EXPECT_EQ(m.completeness, 0.0);
  EXPECT_EQ(m.lost, 1);
}

TEST(TrackMetricsTest, TheOrderOfTracksDoesNotMatter) {
  const Scene scene = scene_of({{0, 1}, {1, 0}, {0, 1}, {0, 1}}, 2);
  std::vector<RecordedTrack> tracks = {track_of({0, 0, 0, 0}), track_of({1, 1, 1, 1}),
                                       track_of({0, 1, 1, 0}, false)};
  const TrackMetrics a = track_metrics(World{}, scene, tracks);
  std::swap(tracks[0], tracks[2]);
  const TrackMetrics b = track_metrics(World{}, scene, tracks);
  EXPECT_EQ(a.correct_association, b.correct_association);
  EXPECT_EQ(a.purity, b.purity);
  EXPECT_EQ(a.completeness, b.completeness);
  EXPECT_EQ(a.swaps, b.swaps);
  EXPECT_EQ(a.lost, b.lost);
}

TEST(TrackMetricsTest, NothingIsNothing) {
  const TrackMetrics m = track_metrics(World{}, Scene{}, {});
  EXPECT_EQ(m.tracks + m.targets + m.present, 0);
  EXPECT_EQ(m.purity, 0.0);
}

}  // namespace
}  // namespace mda
