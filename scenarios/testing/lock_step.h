// TrackForest and ReferenceForest side by side.
#pragma once

#include <map>
#include <span>
#include <string>

#include "scenarios/hypotheses/extract.h"
#include "scenarios/hypotheses/track_forest.h"
#include "scenarios/testing/histories.h"
#include "scenarios/testing/reference_forest.h"

namespace mda::testing {

/// How often what makes the comparison worth something came up.
struct Tally {
  int columns = 0;
  int ended_columns = 0;   ///< of tracks that have missed too often
  int long_columns = 0;    ///< of more than two plots
  int orphaned_pairs = 0;  ///< two-plot leaves born in a scan that the forest has forgotten
  int fixed_tracks = 0;    ///< summed over the decisions
};

class LockStep {
 public:
  LockStep(const ScenarioSpec& spec, int window_k);

  /// Adds a scan to both forests and compares their windows: every column by its plots, its cost
  /// within 1e-9, and the number of live hypotheses. Returns "", or what differs first.
  [[nodiscard]] std::string grow(const Scan& scan);

  /// Lets both forests decide by these columns of window(), which share no row, and compares the
  /// fixed tracks and the total costs. Returns "", or what differs first.
  [[nodiscard]] std::string decide(std::span<const int> columns);

  [[nodiscard]] const WindowInstance& window() const noexcept { return window_; }
  [[nodiscard]] const TrackForest& forest() const noexcept { return forest_; }
  [[nodiscard]] const Histories& histories() const noexcept { return histories_; }
  [[nodiscard]] const Tally& tally() const noexcept { return tally_; }

 private:
  [[nodiscard]] std::string compare_columns();
  void count();

  TrackForest forest_;
  WindowExtractor extractor_;
  WindowInstance window_;
  Histories histories_;
  ReferenceForest reference_;
  std::map<History, double> expected_;  ///< the reference's columns
  Tally tally_;
};

}  // namespace mda::testing
