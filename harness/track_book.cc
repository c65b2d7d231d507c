#include "harness/track_book.h"

#include <algorithm>

namespace mda {
namespace {

/// The plots of a leaf inside the window, the oldest first.
std::vector<PlotPlace> plots_in_window(const TrackForest& forest, int leaf) {
  std::vector<PlotPlace> plots;
  int node = leaf;
  for (int scan = forest.newest_scan(); scan > forest.fixed_scan() && node != kNoParent; --scan) {
    const Node& here = forest.nodes(scan)[static_cast<std::size_t>(node)];
    if (here.plot != kNoPlot) plots.push_back({scan, here.plot});
    node = here.parent;
  }
  std::reverse(plots.begin(), plots.end());
  return plots;
}

}  // namespace

void TrackBook::reset() {
  open_.clear();
  retired_.clear();
}

void TrackBook::note(const TrackForest& forest, std::span<const int> chosen) {
  if (forest.newest_scan() <= forest.window_k()) return;
  const int fixed_next = forest.newest_scan() - forest.window_k() + 1;
  std::map<FirstPlot, std::vector<PlotPlace>> kept;
  for (const int number : chosen) {
    const Leaf& leaf = forest.leaves()[static_cast<std::size_t>(number)];
    if (leaf.birth_scan > fixed_next) continue;
    const FirstPlot first{leaf.birth_scan, leaf.first_plot};
    std::vector<PlotPlace> plots = std::move(open_[first]);
    for (const PlotPlace& place : plots_in_window(forest, number)) {
      if (place.scan <= fixed_next) plots.push_back(place);
    }
    if (leaf.misses == kEnded && leaf.source <= fixed_next) {
      retired_.push_back(std::move(plots));
    } else {
      kept[first] = std::move(plots);
    }
  }
  open_ = std::move(kept);
}

std::vector<RecordedTrack> TrackBook::close(const TrackForest& forest,
                                            std::span<const int> chosen) const {
  std::vector<RecordedTrack> tracks;
  for (const auto& plots : retired_) tracks.push_back({plots, false});
  for (const int number : chosen) {
    const Leaf& leaf = forest.leaves()[static_cast<std::size_t>(number)];
    RecordedTrack track;
    track.alive = leaf.misses != kEnded;
    const auto fixed = open_.find({leaf.birth_scan, leaf.first_plot});
    if (fixed != open_.end()) track.plots = fixed->second;
    const auto last = plots_in_window(forest, number);
    track.plots.insert(track.plots.end(), last.begin(), last.end());
    tracks.push_back(std::move(track));
  }
  return tracks;
}

}  // namespace mda
