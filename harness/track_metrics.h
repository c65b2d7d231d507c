// How well recorded tracks tell the targets apart, against the sources of their plots.
#pragma once

#include <span>

#include "harness/track_book.h"
#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

/// A track counts once it has this many plots.
inline constexpr int kConfirmedPlots = 3;

/// Over the confirmed tracks. The majority source of a track is the target (or the false alarms
/// together) that most of its plots come from, the lowest target number winning ties and false
/// alarms losing them; the track belongs to that target.
struct TrackMetrics {
  int tracks = 0;   ///< confirmed ones
  int targets = 0;  ///< with kConfirmedPlots plots or more: those that could have a track
  /// Share of the tracks' plots that come from the majority source of their track, a target.
  double correct_association = 0.0;
  /// Mean over tracks of the share of their plots that come from the majority source.
  double purity = 0.0;
  /// Share of those targets' plots that are in a track which belongs to their target.
  double completeness = 0.0;
  int track_breaks = 0;  ///< tracks beyond the first that belong to one target
  int swaps = 0;         ///< changes of target from one plot of a track to the next, false alarms
                         ///< passed over
  /// Targets that could have a track, are in the coverage in the last scan, and own no track that
  /// is alive then.
  int lost = 0;
  int present = 0;  ///< targets that could have a track and are in the coverage in the last scan
};

/// Shares are 0 where there is nothing to share. O(plots of the scene + plots of the tracks).
[[nodiscard]] TrackMetrics track_metrics(const World& world, const Scene& scene,
                                         std::span<const RecordedTrack> tracks);

}  // namespace mda
