// The sliding windows of known tracks: S-D assignment (Battistelli et al. 2008, equations
// II.1-II.3), made with hypothesis trees that are grown anew from the tracks' states right before
// the window.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "algorithms/api/views.h"
#include "scenarios/filter/ekf.h"
#include "scenarios/hypotheses/extract.h"
#include "scenarios/known/known_scene.h"
#include "scenarios/known/track_costs.h"
#include "scenarios/spec.h"

namespace mda {

/// One Monte Carlo run. The loop:
///
///     KnownTrackWindows windows(spec, seed, replicate, window_k);
///     while (windows.next()) {
///       ... solve windows.window().problem, choose one Tuple per track ...
///       ... windows.estimates(tuples), windows.decisions(tuples, k) ...
///       windows.advance(tuples);
///     }
class KnownTrackWindows {
 public:
  /// Simulates the scene. Throws std::invalid_argument unless the scenario has known targets,
  /// `window_k` >= 1, and the detection probability is inside (0, 1).
  KnownTrackWindows(const ScenarioSpec& spec, std::uint64_t seed, int replicate, int window_k);

  /// Takes the next scan into the window and makes window(); false, and nothing changes, after the
  /// last scan. Throws std::runtime_error if a layer has more than kMostKnownLeaves nodes, and
  /// std::logic_error if a full window has not been advanced. Time: a filter step per node that is
  /// not a leaf, and a gate test per plot near it in range.
  [[nodiscard]] bool next();

  /// The window of the newest scan, which takes the last min(newest_scan(), window_k) scans.
  ///
  /// Rows: the tracks (dimension 0, exactly once; row n is target n), then the plots of each scan
  /// of the window in the order of the scene (dimensions 1, 2, ..., at most once). Columns: every
  /// sequence of which each plot lies in the gate of what came before it, all-missed included, and
  /// none left out for its cost: the leaves of the tree in their order. Costs: TrackCosts.
  /// leaf_of_column holds the tree's node; retired_nats is 0. The problem's views have the tree and
  /// the tuple cost, and may outlive this object.
  [[nodiscard]] const WindowInstance& window() const noexcept { return window_; }

  /// Fixes the oldest scan: if the window has window_k scans, every track takes what its sequence
  /// says for the oldest scan, and the window slides past it. Nothing is fixed while the window is
  /// still filling. `tuples`: one per track, in any order, with rows of window(); throws
  /// std::invalid_argument otherwise. Also after the last scan. window() stays as it was.
  void advance(std::span<const Tuple> tuples);

  /// The sequences that `columns` of window() stand for.
  [[nodiscard]] std::vector<Tuple> sequences_of(std::span<const int> columns) const;

  /// Per track the filter's state in the newest scan: from the state before window() along the
  /// whole sequence. `tuples` as for advance(), before or after it.
  [[nodiscard]] std::vector<TargetState> estimates(std::span<const Tuple> tuples) const;

  /// Per track the state in scan fixed_scan(), by the decisions fixed so far.
  [[nodiscard]] std::vector<TargetState> lagged_estimates() const;

  /// Per track the plot, counted in its scan, that its sequence takes in scan `k` of window()
  /// (1: oldest), or kNoPlot. `tuples` as for advance(), before or after it.
  [[nodiscard]] std::vector<int> decisions(std::span<const Tuple> tuples, int k) const;

  [[nodiscard]] const KnownScene& scene() const noexcept { return scene_; }
  [[nodiscard]] int tracks() const noexcept { return static_cast<int>(scene_.initial.size()); }
  /// The newest scan in window(), 0 before the first next().
  [[nodiscard]] int newest_scan() const noexcept { return newest_; }
  /// The newest fixed scan, 0 while nothing is fixed.
  [[nodiscard]] int fixed_scan() const noexcept { return fixed_; }
  /// Scans of window().
  [[nodiscard]] int window_scans() const noexcept { return costs_ ? costs_->scans() : 0; }

 private:
  void make_window();
  void add_rows();
  void add_columns(HypothesisTree& tree);
  void check(std::span<const Tuple> tuples) const;

  World world_;
  KnownScene scene_;
  StepCosts steps_;
  int window_k_;
  int newest_ = 0;
  int fixed_ = 0;
  std::vector<Gaussian> base_;  ///< [track], in scan fixed_
  /// What window() was made from; shared with its views.
  std::shared_ptr<const TrackCosts> costs_;
  TreeGrower grower_;
  ProblemBuilder builder_;
  WindowInstance window_;
};

}  // namespace mda
