// What became of the tracks of a closed-loop run: plots that the sliding window has fixed, track by
// track.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "scenarios/hypotheses/track_forest.h"

namespace mda {

/// A plot's place: scan, counted from 1, and number in it.
struct PlotPlace {
  int scan = 0;
  int plot = 0;
};

struct RecordedTrack {
  std::vector<PlotPlace> plots;  ///< in the order of their scans
  bool alive = false;            ///< had not ended after the last scan
};

/// Follows the decisions of a forest. A track is known by its first plot.
class TrackBook {
 public:
  void reset();

  /// Call after every grow(), before decide(): writes down what decide(chosen) is about to fix. A
  /// fixed track that is not chosen any more turns out to be false alarms and is struck out.
  void note(const TrackForest& forest, std::span<const int> chosen);

  /// After the last scan: all tracks, those chosen last with the plots of the last window.
  [[nodiscard]] std::vector<RecordedTrack> close(const TrackForest& forest,
                                                 std::span<const int> chosen) const;

 private:
  using FirstPlot = std::pair<int, int>;

  std::map<FirstPlot, std::vector<PlotPlace>> open_;  ///< the fixed plots of the fixed tracks
  std::vector<std::vector<PlotPlace>> retired_;
};

}  // namespace mda
