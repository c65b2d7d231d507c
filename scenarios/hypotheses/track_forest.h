// The track hypotheses of a sliding window: a forest, one layer of nodes per scan, grown by one
// scan at a time and cut back to what the decisions leave (Storms & Spieksma 2003, section 3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scenarios/filter/ekf.h"
#include "scenarios/hypotheses/buffer.h"
#include "scenarios/hypotheses/cost.h"
#include "scenarios/hypotheses/indexed_scan.h"
#include "scenarios/hypotheses/lanes.h"
#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

/// A window that is too wide for its scene ends with an error, not with all memory taken: at this
/// many hypotheses a forest has some gigabytes.
inline constexpr int kMostLeaves = 1 << 25;

inline constexpr int kNoPlot = -1;
inline constexpr int kNoParent = -1;

/// What one scan adds to a track. Children of a node are neighbours, parents are ascending, births
/// (without a parent) come last: so the descendants of any range of nodes are a range.
struct Node {
  int parent;  ///< in the layer before
  int plot;    ///< in its scan, or kNoPlot
};

/// A hypothesis as of the newest scan. A miss needs no state of its own: it is the state after the
/// last plot and the number of misses since.
struct Leaf {
  double cost;  ///< nats, since its first plot
  /// While it lives: with one or two plots the last plot, with more the posterior, either in the
  /// scan of the last plot. Once ended: the scan that ended it.
  int source;
  int first_plot;  ///< in scan birth_scan
  std::int16_t birth_scan;
  std::uint8_t plots;   ///< 3 stands for 3 and more
  std::uint8_t misses;  ///< since the last plot, or kEnded
};

inline constexpr std::uint8_t kEnded = 255;

class TrackForest {
 public:
  TrackForest() = default;

  /// Starts anew for windows of `window_k` >= 1 scans; keeps all memory. The world needs a positive
  /// clutter rate, a detection probability inside (0, 1), and fewer than 32,768 scans; the model at
  /// most 100 misses. With `keeps_costs`, node_cost() is there.
  void reset(const World& world, const TrackerModel& model, int window_k, bool keeps_costs = false);

  /// Adds the next scan: every live hypothesis gets a child for each plot in its gate and one for
  /// a miss, and every plot starts a hypothesis. Plots must be in the order of their range.
  /// Time: O(hypotheses + children); no allocation once the buffers have grown. Throws
  /// std::runtime_error beyond kMostLeaves; then only reset() may follow.
  void grow(const Scan& scan);

  /// Fixes scan newest - K + 1 (equations 10-12): of each chosen leaf that was born by then only
  /// the subtree that agrees with it in that scan is kept, as the fixed track that the next windows
  /// continue; all other hypotheses born by then are dropped, those born later stay. Does
  /// nothing while all scans are still in the window (newest <= K). A chosen leaf that has ended by
  /// the fixed scan leaves the forest for good, and its cost goes to retired_cost().
  /// `chosen` are leaf numbers, no two sharing a plot or track.
  void decide(std::span<const int> chosen);

  /// The filter's state of a live leaf in the newest scan: predicted over the misses since its last
  /// plot. O(misses).
  [[nodiscard]] Gaussian state_of(const Leaf& leaf) const;

  [[nodiscard]] int newest_scan() const noexcept { return newest_; }
  [[nodiscard]] int window_k() const noexcept { return window_k_; }
  /// The newest fixed scan, 0 before the first decision: the window starts after it.
  [[nodiscard]] int fixed_scan() const noexcept { return fixed_; }
  /// Fixed tracks: the nodes of layer fixed_scan().
  [[nodiscard]] int tracks() const noexcept { return fixed_ == 0 ? 0 : layer(fixed_).nodes.size(); }
  /// Sum of the costs of the tracks that ended before this window, nats.
  [[nodiscard]] double retired_cost() const noexcept { return retired_cost_; }
  /// Hypotheses made since reset(), those that ended at once included.
  [[nodiscard]] std::int64_t hypotheses() const noexcept { return hypotheses_; }

  /// Counts in the order of the nodes of the newest scan.
  [[nodiscard]] std::span<const Leaf> leaves() const noexcept {
    return {leaves_.begin(), leaves_.end()};
  }
  /// Nodes of a scan from fixed_scan() (if any) to newest_scan(); those of the newest are leaves.
  [[nodiscard]] std::span<const Node> nodes(int scan) const noexcept {
    return {layer(scan).nodes.begin(), layer(scan).nodes.end()};
  }
  /// What the node's track had cost by then, nats; needs keeps_costs.
  [[nodiscard]] double node_cost(int scan, int node) const { return layer(scan).costs[node]; }
  [[nodiscard]] int plots(int scan) const { return scans_[scan_index(scan)].size(); }
  [[nodiscard]] const TrackerModel& model() const noexcept { return model_; }

  /// Cost of a leaf as a column: what the window's objective counts, nats.
  [[nodiscard]] double column_cost(const Leaf& leaf) const noexcept {
    return leaf.misses == kEnded ? leaf.cost : leaf.cost - leaf.misses * terms_.live_discount;
  }
  /// Whether a leaf may be a column at all: it has plots enough and gains on clutter.
  [[nodiscard]] bool is_column(const Leaf& leaf) const noexcept {
    return column_cost(leaf) < 0.0 && leaf.plots >= least_plots_;
  }

 private:
  struct Layer {
    Buffer<Node> nodes;
    Buffer<double> costs;  ///< per node, if costs are kept
    int births_begin = 0;
  };
  struct Interval {
    int begin, end;
  };

  static std::size_t scan_index(int scan) { return static_cast<std::size_t>(scan - 1); }
  [[nodiscard]] Layer& layer(int scan) { return layers_[ring_index(scan, layers_.size())]; }
  [[nodiscard]] const Layer& layer(int scan) const {
    return layers_[ring_index(scan, layers_.size())];
  }
  [[nodiscard]] Buffer<LaneState>& posteriors(int scan) {
    return posteriors_[ring_index(scan, posteriors_.size())];
  }
  [[nodiscard]] const Buffer<LaneState>& posteriors(int scan) const {
    return posteriors_[ring_index(scan, posteriors_.size())];
  }
  static std::size_t ring_index(int scan, std::size_t size) {
    return static_cast<std::size_t>(scan) % size;
  }

  // Growing (grow.cc).
  void load(const Leaf& leaf, int lane);
  [[nodiscard]] LaneState state_after_last_plot(const Leaf& leaf, int last_scan) const;
  [[nodiscard]] LaneState newborn(const CartesianPlot& plot) const;
  [[nodiscard]] LaneState two_plots(const Leaf& leaf, int last_scan) const;
  void store_costs();
  void expand_block(const IndexedScan& scan, int begin, int end);
  void expand(const IndexedScan& scan, int parent, int lane);
  void store_posteriors(const IndexedScan& scan, int first_child, int lane);
  void append_miss(const Leaf& leaf, int parent);
  void append(const Leaf& leaf, const Node& node);
  void append_births(const IndexedScan& scan);

  // Deciding (track_forest.cc).
  void find_survivors(int scan, std::span<const int> chosen);
  void move_node(int scan, int from, int to, int parent);
  void keep_survivors(int scan);
  void keep_descendants(int scan);

  World world_;
  TrackerModel model_;
  CostTerms terms_;
  LaneModel lane_model_;
  PredictLanes predict_ = predict_lanes_for_this_cpu();
  std::vector<AxisNoise> noise_after_;  ///< [misses]: over misses + 1 scan periods
  std::vector<double> pair_noise_;      ///< [scans]: of a differenced velocity, km^2/s^2
  double velocity_variance_ = 0.0;
  int least_plots_ = 2;
  int window_k_ = 1;
  bool keeps_costs_ = false;

  int newest_ = 0;
  int fixed_ = 0;
  double retired_cost_ = 0.0;
  std::int64_t hypotheses_ = 0;
  std::vector<IndexedScan> scans_;             ///< all scans so far, and room for more
  std::vector<Layer> layers_;                  ///< ring: the fixed scan and those of the window
  std::vector<Buffer<LaneState>> posteriors_;  ///< ring: scans that a live leaf's last plot is in
  Buffer<Leaf> leaves_;                        ///< of the newest scan, as its nodes
  Buffer<Leaf> next_;                          ///< the leaves being made
  std::vector<int> survivors_;
  std::vector<Interval> kept_;   ///< what is left of the layer above, in its old numbers
  std::vector<Interval> below_;  ///< and of the layer at hand
  Lanes lanes_;
};

}  // namespace mda
