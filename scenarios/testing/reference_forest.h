// The track hypotheses of a sliding window once more, plain and slow: what TrackForest is tested
// against. Every hypothesis is an object that remembers all its plots; nothing is shared.
#pragma once

#include <compare>
#include <map>
#include <span>
#include <vector>

#include "scenarios/filter/ekf.h"
#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda::testing {

struct PlotOfScan {
  int scan = 0;  ///< counted from 1
  int plot = 0;  ///< its place in the scan
  auto operator<=>(const PlotOfScan&) const = default;
};

/// All plots of a track, oldest first. In one scan no two hypotheses have the same.
using History = std::vector<PlotOfScan>;

/// The plots of a history up to a scan.
[[nodiscard]] History up_to(const History& history, int scan);

/// Written from Storms & Spieksma 2003, equations (6), (8), (10)-(12) and (14), and from what the
/// values of TrackerModel mean; shares with TrackForest the filter's plain form and f_phi only.
class ReferenceForest {
 public:
  ReferenceForest(const World& world, const TrackerModel& model, int window_k)
      : world_(world), model_(model), window_k_(window_k) {}

  /// O(hypotheses x plots).
  void grow(const Scan& scan);

  /// The columns of the window and their costs in nats, false alarms left out.
  [[nodiscard]] std::map<History, double> columns() const;

  /// Fixes scan newest - K + 1 as the chosen columns say, which must not share plots. Nothing
  /// happens while newest <= K.
  void decide(std::span<const History> chosen);

  [[nodiscard]] int newest_scan() const noexcept { return newest_; }
  /// 0 before the first decision.
  [[nodiscard]] int fixed_scan() const noexcept { return fixed_; }
  /// Hypotheses that may still get plots.
  [[nodiscard]] int live() const;
  /// The fixed tracks, as far as they are fixed, in no particular order.
  [[nodiscard]] const std::vector<History>& tracks() const noexcept { return tracks_; }
  /// Tracks that had ended when their last scan was fixed, each with its cost.
  [[nodiscard]] const std::map<History, double>& retired() const noexcept { return retired_; }

 private:
  struct Hypothesis {
    History history;
    Gaussian state;     ///< in the newest scan, or in the one that ended it
    Plot first;         ///< where it was born
    double cost = 0.0;  ///< without the misses since the last plot
    int misses = 0;     ///< since the last plot
    int end_scan = 0;   ///< the scan that ended it, 0 while it lives
  };

  void add_children(const Hypothesis& parent, const Scan& scan, std::vector<Hypothesis>& out) const;
  [[nodiscard]] Hypothesis missed(const Hypothesis& parent, const Gaussian& predicted) const;
  [[nodiscard]] double cost(const Hypothesis& hypothesis) const;

  World world_;
  TrackerModel model_;
  int window_k_;
  int newest_ = 0;
  int fixed_ = 0;
  std::vector<Hypothesis> hypotheses_;
  std::vector<History> tracks_;
  std::map<History, double> retired_;
};

}  // namespace mda::testing
