// The windows of one scan over tracks of position targets: single-scan association with its
// probabilities and likelihoods pair by pair.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "algorithms/api/views.h"
#include "scenarios/cartesian/position_filter.h"
#include "scenarios/cartesian/position_scene.h"
#include "scenarios/hypotheses/extract.h"
#include "scenarios/spec.h"

namespace mda {

/// A track is dropped when after an update it is farther than this from its target, or its variance
/// of position on an axis is more than the second: lost tracks would open gates over half the
/// scene. It uses the truth, which a tracker does not know.
inline constexpr double kDroppedKm = 2.0;
inline constexpr double kDroppedVarianceKm2 = 1.0;

/// With a density of clutter of 0, as in quiet scans, no plot could be told from a miss: it is
/// taken to be at least as if there were one plot in a hundred scans of 400 km^2.
inline constexpr double kLeastClutterPerKm2 = 0.01 / 400.0;

/// What a track makes of a scan: plots, counted in the scan, and how probable each is its own.
struct Belief {
  struct Item {
    int plot = 0;
    double probability = 1.0;  ///< >= 0
  };
  std::vector<Item> items;  ///< none: a miss
};

/// One Monte Carlo run. The loop:
///
///     PositionWindows windows(spec, seed, replicate);
///     while (windows.next()) {
///       ... solve windows.window().problem ...
///       windows.advance(windows.beliefs_of(x));
///     }
class PositionWindows {
 public:
  /// Simulates the scene. Throws std::invalid_argument unless the scenario has position targets and
  /// the detection probability is inside (0, 1).
  PositionWindows(const ScenarioSpec& spec, std::uint64_t seed, int replicate);

  /// Predicts all tracks to the next scan and makes window(); false, and nothing changes, after the
  /// last scan. Throws std::logic_error without an advance() since the last one, and
  /// std::runtime_error if a track's innovation has no likelihood. O(tracks x plots).
  [[nodiscard]] bool next();

  /// The window of the newest scan.
  ///
  /// Rows: the tracks that are not dropped (dimension 0, exactly once, in the order of their
  /// targets), then the plots in the order of the scene (dimension 1, at most once). Columns: per
  /// track its plots in the gate, in their order, at -ln(P_D N(nu; 0, S) / lambda), then its miss
  /// at -ln(1 - P_D P_G). lambda is the scenario's density of clutter, also where that thins out,
  /// and in quiet scans kLeastClutterPerKm2. The views have the tree, the pairs and the tuple cost.
  /// leaf_of_column holds the tree's node.
  [[nodiscard]] const WindowInstance& window() const noexcept { return window_; }

  /// Moves every track to the newest scan by what it believes: one for each target, in their order.
  /// Dropped tracks coast whatever they believe. Then drops those that are to be dropped. Throws
  /// std::invalid_argument for a plot that is not there or a probability that is negative or not
  /// finite, and std::logic_error without a next() since the last one.
  void advance(std::span<const Belief> beliefs);

  /// What a value for every column of window() makes the tracks believe; misses and values of 0 or
  /// less are left out.
  [[nodiscard]] std::vector<Belief> beliefs_of(std::span<const double> x) const;

  /// Every track believes in its target's plot where that is there.
  [[nodiscard]] std::vector<Belief> true_beliefs() const;

  /// Target of a track's row in window().
  [[nodiscard]] int target_of_row(int row) const {
    return target_of_row_[static_cast<std::size_t>(row)];
  }

  /// [target]: for the newest scan, before and after advance().
  [[nodiscard]] const std::vector<MotionEstimate>& predicted() const noexcept { return predicted_; }
  [[nodiscard]] const std::vector<MotionEstimate>& estimates() const noexcept { return estimates_; }
  [[nodiscard]] bool is_dropped(int target) const {
    return dropped_[static_cast<std::size_t>(target)];
  }

  [[nodiscard]] const PositionRun& scene() const noexcept { return scene_; }
  [[nodiscard]] const PositionScan& scan() const {
    return scene_.scans[static_cast<std::size_t>(newest_) - 1];
  }
  [[nodiscard]] int targets() const noexcept { return static_cast<int>(estimates_.size()); }
  /// The newest scan, 0 before the first next().
  [[nodiscard]] int newest_scan() const noexcept { return newest_; }

 private:
  void make_window();
  /// lambda of the newest scan, per km^2.
  [[nodiscard]] double clutter_density() const;
  [[nodiscard]] PairView pairs_without_columns() const;
  void add_columns(HypothesisTree& tree, PairView& pairs);
  int add_column(HypothesisTree& tree, int track, int row, double cost);
  void drop_lost_tracks();

  World world_;
  PositionTargets targets_;
  double gate_;
  PositionRun scene_;
  std::vector<MotionModel> models_;  ///< [target]
  std::vector<MotionEstimate> estimates_;
  std::vector<MotionEstimate> predicted_;
  std::vector<PositionInnovation> expected_;  ///< [target]; of dropped ones without meaning
  std::vector<bool> dropped_;
  std::vector<int> target_of_row_;
  int newest_ = 0;
  bool advanced_ = true;
  ProblemBuilder builder_;
  WindowInstance window_;
};

}  // namespace mda
