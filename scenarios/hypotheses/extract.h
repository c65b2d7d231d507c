// A window of the forest as an association problem: model (13) of Storms & Spieksma 2003, or (9)
// while no scan has been fixed.
#pragma once

#include <vector>

#include "algorithms/api/problem.h"
#include "scenarios/hypotheses/track_forest.h"

namespace mda {

/// A frozen problem, and what its numbers stand for.
struct WindowInstance {
  /// Rows: the fixed tracks (dimension 0), then the plots of each scan of the window (1, 2, ...).
  AssociationProblem problem;
  /// Leaf of the forest that each column stands for, -1 for a column of false alarms.
  std::vector<int> leaf_of_column;
  /// |Z^K|, the number of tracks if nothing were gated: may exceed 2^53.
  double ungated_columns = 0.0;
  double retired_nats = 0.0;  ///< TrackForest::retired_cost()
};

class WindowExtractor {
 public:
  /// Columns are the leaves for which TrackForest::is_column holds, in the order of the leaves;
  /// with RowRule::kEquality a column of cost 0 for each row follows. O(columns x scans of the
  /// window).
  [[nodiscard]] WindowInstance extract(const TrackForest& forest);

 private:
  void add_rows(const TrackForest& forest);
  void add_column(const TrackForest& forest, int leaf);

  ProblemBuilder builder_;
  std::vector<int> first_row_of_scan_;  ///< [scan - fixed scan]; [0]: of the fixed tracks
  std::vector<int> rows_;
};

}  // namespace mda
