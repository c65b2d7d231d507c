// V_T of Storms & Spieksma 2003, section 5: what the true tracks cost under the tracker's model.
#pragma once

#include <vector>

#include "scenarios/filter/ekf.h"
#include "scenarios/hypotheses/cost.h"
#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

/// Follows every target by its own plots, with the filter of the hypotheses but without a gate. A
/// track that has missed more than p scans in a row ends, trailing misses charged as the model
/// says; the target's next plot starts another one. A track of fewer plots than a column needs
/// counts as false alarms, at cost 0.
class TruthCost {
 public:
  /// Needs what TrackForest::reset() needs.
  void reset(const World& world, const TrackerModel& model);

  /// Adds the next scan. O(targets so far).
  void add(const Scan& scan);

  /// Cost of the true tracks up to the newest scan, nats.
  [[nodiscard]] double cost() const;

 private:
  struct Track {
    Gaussian state;
    Plot first;
    double cost = 0.0;
    int plots = 0;   ///< 0: no track at present
    int misses = 0;  ///< since the last plot
  };

  void extend(Track& track, const Plot& plot) const;
  void miss(Track& track);
  [[nodiscard]] double counted(const Track& track) const;

  World world_;
  TrackerModel model_;
  CostTerms terms_;
  int least_plots_ = 2;
  std::vector<Track> tracks_;  ///< by target
  std::vector<const Plot*> plot_of_target_;
  double ended_cost_ = 0.0;
};

}  // namespace mda
