#include "harness/position_metrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mda {
namespace {

constexpr std::size_t kScans = 12;

TargetState at(double x, double y) { return {x, 0.1, y, 0.0}; }

/// East along y = `y_km`, 0.1 km a scan.
StateSeries lane(double y_km) {
  StateSeries series;
  for (std::size_t scan = 0; scan < kScans; ++scan) {
    series.push_back(at(0.1 * static_cast<double>(scan), y_km));
  }
  return series;
}

/// From one lane to another, half-way.
StateSeries change_of_lane(double from_km, double to_km) {
  StateSeries series = lane(from_km);
  const StateSeries after = lane(to_km);
  for (std::size_t scan = kScans / 2; scan < kScans; ++scan) series[scan] = after[scan];
  return series;
}

TrackSet three_lanes(std::vector<StateSeries> tracks) {
  return {std::move(tracks), {lane(0.0), lane(0.5), lane(3.0)}, {false, false, false}};
}

TEST(PositionMetrics, ErrorsAreDistancesScanByScan) {
  StateSeries filtered = lane(0.3);
  filtered[2].x += 0.4;
  filtered[2].vy = 0.2;
  const TrackErrors errors = track_errors(filtered, lane(0.0), lane(0.0));
  ASSERT_EQ(errors.position_km.size(), kScans);
  EXPECT_NEAR(errors.position_km[0], 0.3, 1e-12);
  EXPECT_NEAR(errors.position_km[2], 0.5, 1e-12);
  EXPECT_NEAR(errors.velocity_km_s[2], 0.2, 1e-12);
  EXPECT_EQ(sum_of_squares(errors.predicted_position_km), 0.0);
  EXPECT_EQ(sum_of_squares(errors.predicted_velocity_km_s), 0.0);
  EXPECT_NEAR(sum_of_squares(errors.position_km), 11 * 0.09 + 0.25, 1e-12);
}

TEST(PositionMetrics, OnlyTheLastFiveScansDecideOnLoss) {
  std::vector<double> error(kScans, 0.1);
  error[kScans - 6] = 9.0;
  EXPECT_TRUE(is_maintained(error, kStrictLossKm));
  for (std::size_t late = kScans - 5; late < kScans; ++late) {
    std::vector<double> lost = error;
    lost[late] = 0.5;
    EXPECT_FALSE(is_maintained(lost, kStrictLossKm));
    EXPECT_TRUE(is_maintained(lost, kWideLossKm));
  }
  EXPECT_FALSE(is_maintained({0.45}, kStrictLossKm)) << "at the threshold it is lost";
  EXPECT_TRUE(is_maintained({0.0, 0.0}, kStrictLossKm)) << "fewer scans than that";
}

TEST(PositionMetrics, TracksOnTheirTargetsHaveNeitherSwappedNorMerged) {
  const TrackSet set = three_lanes({lane(0.05), lane(0.4), lane(3.0)});
  EXPECT_EQ(swaps(set), 0);
  EXPECT_EQ(coalescences(set, 0.15), 0);
}

TEST(PositionMetrics, TracksThatChangePlacesAreOneSwap) {
  TrackSet set = three_lanes({change_of_lane(0.0, 0.5), change_of_lane(0.5, 0.0), lane(3.0)});
  EXPECT_EQ(swaps(set), 1);
  EXPECT_EQ(coalescences(set, 0.15), 0);
  set.dropped[0] = true;
  EXPECT_EQ(swaps(set), 0);
}

TEST(PositionMetrics, OneTrackOnTheOthersTargetIsNoSwap) {
  EXPECT_EQ(swaps(three_lanes({change_of_lane(0.0, 0.5), lane(0.5), lane(3.0)})), 0);
  EXPECT_EQ(swaps(three_lanes({lane(1.0), lane(-0.5), lane(3.0)})), 0) << "both lost";
}

TEST(PositionMetrics, TracksThatGoOnTogetherAreOneCoalescence) {
  TrackSet set = three_lanes({change_of_lane(0.0, 0.2), change_of_lane(0.5, 0.3), lane(3.0)});
  EXPECT_EQ(coalescences(set, 0.15), 1);
  EXPECT_EQ(swaps(set), 0);
  EXPECT_EQ(coalescences(set, 0.09), 0) << "not that near";
  set.tracks[0].back() = at(1.1, 0.0);
  EXPECT_EQ(coalescences(set, 0.15), 0) << "they part in the last scan";
  set = three_lanes({lane(0.2), lane(0.3), lane(3.0)});
  set.dropped[1] = true;
  EXPECT_EQ(coalescences(set, 0.15), 0);
}

TEST(PositionMetrics, TracksOfTargetsThatAreTogetherMayBeSo) {
  TrackSet set = three_lanes({lane(0.0), lane(0.0), lane(3.0)});
  set.targets[1] = lane(0.1);
  EXPECT_EQ(coalescences(set, 0.15), 0);
}

TEST(PositionMetrics, TheNumberingDoesNotMatter) {
  const TrackSet set =
      three_lanes({change_of_lane(0.0, 0.5), change_of_lane(0.5, 0.0), change_of_lane(3.0, 0.1)});
  const TrackSet other = {{set.tracks[2], set.tracks[0], set.tracks[1]},
                          {set.targets[2], set.targets[0], set.targets[1]},
                          set.dropped};
  EXPECT_EQ(swaps(other), swaps(set));
  EXPECT_EQ(coalescences(other, 0.15), coalescences(set, 0.15));
  EXPECT_EQ(coalescences(set, 0.15), 1);
}

}  // namespace
}  // namespace mda
