// What sequences of plots cost the known tracks of a window, and the trees of those in the gates.
#pragma once

#include <span>
#include <vector>

#include "algorithms/api/views.h"
#include "scenarios/known/doppler_ekf.h"
#include "scenarios/known/known_scene.h"
#include "scenarios/spec.h"

namespace mda {

/// Nodes of a layer here hold their states and become columns all: a window that is too wide ends
/// with an error well before it takes all memory.
inline constexpr int kMostKnownLeaves = 1 << 20;

/// With a density of clutter of 0 no plot could be told from a miss: it is taken to be at least as
/// if there were one plot of clutter in a hundred scans.
inline constexpr double kLeastClutterPerScan = 0.01;

/// The part of the costs that is the same for all windows of a scenario, nats:
/// a plot costs -ln(P_d N(nu; 0, S) / lambda), a miss -ln(1 - P_d) (equation II.1 with the
/// likelihood made a ratio; CostNormalisation says which lambda).
struct StepCosts {
  Eigen::Matrix3d plot_covariance;
  double detection = 0.0;  ///< -ln(P_d / lambda), per km rad km/s
  double miss = 0.0;       ///< -ln(1 - P_d)
  double gate = 0.0;       ///< chi-square

  StepCosts(const ScenarioSpec& spec, const PlotBox& clutter_box);

  [[nodiscard]] double plot(const DopplerInnovation& expected, double distance) const noexcept {
    return detection - expected.log_peak + 0.5 * distance;
  }
};

/// All that the costs of a window depend on: the tracks' states right before it and its plots.
/// The past of the tracks costs nothing.
class TrackCosts {
 public:
  /// `base`: [track]; `scans`: of the window, oldest first.
  TrackCosts(const World& world, const StepCosts& steps, std::vector<Gaussian> base,
             std::span<const KnownScan> scans);

  /// Nats, in the gates or not. O(scans). The tuple's rows must be of this window.
  [[nodiscard]] double cost(const Tuple& tuple) const;

  /// The filter's state after the first `scans` steps of a sequence.
  [[nodiscard]] Gaussian state(const Tuple& tuple, int scans) const;

  [[nodiscard]] int tracks() const noexcept { return static_cast<int>(base_.size()); }
  [[nodiscard]] int scans() const noexcept { return static_cast<int>(first_row_.size()) - 1; }
  /// Row of the first plot of scan k (1: oldest); k = scans() + 1: number of rows.
  [[nodiscard]] int first_row(int k) const { return first_row_[static_cast<std::size_t>(k) - 1]; }
  /// Row of the first plot of scan k at `range_km` or farther. O(log plots).
  [[nodiscard]] int first_row_from(int k, double range_km) const;
  [[nodiscard]] const DopplerMeasurement& plot(int row) const {
    return plots_[static_cast<std::size_t>(row - tracks())];
  }
  [[nodiscard]] const World& world() const noexcept { return world_; }
  [[nodiscard]] const StepCosts& steps() const noexcept { return steps_; }
  [[nodiscard]] const std::vector<Gaussian>& base() const noexcept { return base_; }

 private:
  World world_;
  StepCosts steps_;
  std::vector<Gaussian> base_;
  std::vector<int> first_row_;
  std::vector<DopplerMeasurement> plots_;  ///< of all scans, in the order of their rows
};

/// Grows the trees of all tracks of a window; keeps its memory between windows.
class TreeGrower {
 public:
  /// The tree of every sequence of which each plot lies in the gate of what came before it, a
  /// track's miss always. Columns are not numbered yet. Throws std::runtime_error if a layer has
  /// more than kMostKnownLeaves nodes.
  [[nodiscard]] HypothesisTree grow(const TrackCosts& costs);

 private:
  /// `state`: of `node`, which is in the layer before k, after its scan.
  void add_children(const TrackCosts& costs, HypothesisTree& tree, int node, const Gaussian& state,
                    int k);
  static void add_node(HypothesisTree& tree, int parent, int row, int track, double step);

  std::vector<Gaussian> states_;  ///< of the layer before, after its scan
  std::vector<Gaussian> next_;    ///< of this layer
};

}  // namespace mda
