#include "harness/track_metrics.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mda {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

int source_of(const Scene& scene, const PlotPlace& place) {
  return scene.scans[index(place.scan - 1)].plots[index(place.plot)].source;
}

struct Ownership {
  int owner = kFalseAlarm;
  int plots_of_owner = 0;
};

Ownership owner_of(const Scene& scene, const RecordedTrack& track) {
  std::map<int, int> plots_of_source;
  for (const PlotPlace& place : track.plots) ++plots_of_source[source_of(scene, place)];
  Ownership most;
  for (const auto& [source, plots] : plots_of_source) {  // false alarms (-1) come first
    const bool beats_clutter = most.owner == kFalseAlarm && plots == most.plots_of_owner;
    if (plots > most.plots_of_owner || beats_clutter) most = {source, plots};
  }
  return most;
}

int swaps_in(const Scene& scene, const RecordedTrack& track) {
  int swaps = 0;
  int last = kFalseAlarm;
  for (const PlotPlace& place : track.plots) {
    const int source = source_of(scene, place);
    if (source == kFalseAlarm) continue;
    if (last != kFalseAlarm && source != last) ++swaps;
    last = source;
  }
  return swaps;
}

std::vector<int> plots_of_targets(const Scene& scene) {
  std::vector<int> plots(index(scene.targets), 0);
  for (const Scan& scan : scene.scans) {
    for (const Plot& plot : scan.plots) {
      if (plot.source != kFalseAlarm) ++plots[index(plot.source)];
    }
  }
  return plots;
}

double share(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

/// What the tracks of one target add up to.
struct Held {
  int tracks = 0;
  int plots = 0;
  bool alive = false;
};

void count_targets(const World& world, const Scene& scene, const std::vector<Held>& held,
                   TrackMetrics& metrics) {
  const std::vector<int> plots = plots_of_targets(scene);
  double detectable = 0.0;
  double found = 0.0;
  for (std::size_t t = 0; t < plots.size(); ++t) {
    metrics.track_breaks += std::max(0, held[t].tracks - 1);
    if (plots[t] < kConfirmedPlots) continue;
    ++metrics.targets;
    detectable += plots[t];
    found += held[t].plots;
  }
  metrics.completeness = share(found, detectable);
  if (scene.scans.empty()) return;
  for (const TruePosition& last : scene.scans.back().truth) {
    const bool inside = std::hypot(last.state.x, last.state.y) <= world.range_km;
    if (!inside || plots[index(last.target)] < kConfirmedPlots) continue;
    ++metrics.present;
    metrics.lost += held[index(last.target)].alive ? 0 : 1;
  }
}

}  // namespace

TrackMetrics track_metrics(const World& world, const Scene& scene,
                           std::span<const RecordedTrack> tracks) {
  TrackMetrics metrics;
  std::vector<Held> held(index(scene.targets));
  double plots = 0.0;
  double right = 0.0;
  for (const RecordedTrack& track : tracks) {
    if (track.plots.size() < index(kConfirmedPlots)) continue;
    const Ownership ownership = owner_of(scene, track);
    const auto size = static_cast<double>(track.plots.size());
    ++metrics.tracks;
    plots += size;
    metrics.purity += ownership.plots_of_owner / size;
    metrics.swaps += swaps_in(scene, track);
    if (ownership.owner == kFalseAlarm) continue;
    right += ownership.plots_of_owner;
    Held& target = held[index(ownership.owner)];
    ++target.tracks;
    target.plots += ownership.plots_of_owner;
    target.alive = target.alive || track.alive;
  }
  metrics.purity = share(metrics.purity, metrics.tracks);
  metrics.correct_association = share(right, plots);
  count_targets(world, scene, held, metrics);
  return metrics;
}

}  // namespace mda
