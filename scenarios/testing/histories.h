// Reads TrackForest through its public face, and remembers what it forgets.
#pragma once

#include <span>
#include <vector>

#include "scenarios/hypotheses/extract.h"
#include "scenarios/hypotheses/track_forest.h"
#include "scenarios/testing/reference_forest.h"

namespace mda::testing {

/// Follows one forest from its reset on.
class Histories {
 public:
  /// All plots of a leaf, those of its fixed track included.
  [[nodiscard]] History of_leaf(const TrackForest& forest, int leaf) const;

  /// All plots of a column, as its rows tell.
  [[nodiscard]] History of_column(const TrackForest& forest, const AssociationProblem& problem,
                                  int column) const;

  /// To be called before forest.decide(chosen).
  void before_decision(const TrackForest& forest, std::span<const int> chosen);

  /// Of the fixed tracks, in the order of their rows.
  [[nodiscard]] const std::vector<History>& tracks() const noexcept { return tracks_; }

 private:
  std::vector<History> tracks_;
};

}  // namespace mda::testing
