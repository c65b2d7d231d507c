// What some published methods need to see of a window beside its columns. The makers of a window
// fill these plain arrays on demand (scenarios/hypotheses).
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace mda {

inline constexpr int kNoRow = -1;     ///< no plot (a missed detection), or no fixed track
inline constexpr int kNoNode = -1;    ///< the parent of a root
inline constexpr int kNoColumn = -1;  ///< of a node that is not in the last layer

/// The columns as trees: a node is a partial track, the path from its root to it. Layer 0 holds the
/// fixed tracks, layer k what they, and the tracks born in the window, may have done by scan k.
/// The law: every node of the last layer is one column, which uses the rows on its path, and costs
/// the sum of the steps on it. Columns that are no track (false alarms) have no node. Nodes are
/// ordered by layer; in a layer parents ascend and the births (first plots, roots too) come last,
/// so the children of a node are neighbours. Every node leads to a column.
struct HypothesisTree {
  std::vector<int> layer_begin;  ///< K + 2 entries: first node of layer k; the last one: all nodes
  std::vector<int> parent;       ///< in the layer before; kNoNode: a fixed track or a birth
  std::vector<int> row;          ///< the track's in layer 0; above, the plot's or kNoRow for a miss
  std::vector<int> track;        ///< row of the fixed track that the node continues, or kNoRow
  std::vector<double> step;      ///< nats that this step adds; of a root, all until then
  std::vector<double> cost;      ///< nats, sum of the steps from the root
  std::vector<int> child_begin;  ///< the children of node n are the nodes from child_begin[n] ...
  std::vector<int> child_end;    ///< ... up to, but without, child_end[n]
  std::vector<int> column;       ///< of a node in the last layer, else kNoColumn

  [[nodiscard]] int nodes() const noexcept { return static_cast<int>(parent.size()); }
  /// K.
  [[nodiscard]] int scans() const noexcept { return static_cast<int>(layer_begin.size()) - 2; }
};

/// Fills in child_begin and child_end from layer_begin and parent. O(nodes).
void index_children(HypothesisTree& tree);

/// A track's choice in every scan, or what three sensors' reports are said to be one target: a
/// sequence that may or may not be one of the columns.
struct Tuple {
  int track = kNoRow;     ///< row of the fixed track; kNoRow in windows of sensors
  std::vector<int> rows;  ///< [k - 1]: row of the plot taken in scan (sensor) k, or kNoRow

  friend bool operator==(const Tuple&, const Tuple&) = default;
};

/// Exact cost of any sequence of a fixed track, or of any tuple of sensors' reports, gated or not,
/// nats; what the column of it costs, if there is one. Infinite if it has no likelihood at all.
using TupleCost = std::function<double(const Tuple&)>;

/// One scan of fixed tracks, seen pair by pair: n tracks, m plots. Arrays of pairs hold track t and
/// plot j at t * m + j, whether the plot lies in the track's gate or not.
struct PairView {
  std::vector<int> track_row;    ///< [t]: row of the problem, dimension 0
  std::vector<int> plot_row;     ///< [j]: row of the problem, dimension 1
  std::vector<double> distance;  ///< squared Mahalanobis distance of the innovation, chi-square
  std::vector<double> line_distance;   ///< km^2: squared distance of the plot from the line through
                                       ///< the predicted position along the predicted step
  std::vector<double> log_likelihood;  ///< ln N(innovation; 0, S), S in km^2
  std::vector<int> column;             ///< of a pair in the gate, else kNoColumn
  std::vector<int> miss_column;        ///< [t]: column of no detection
  double gate = 0.0;                   ///< chi-square
  double detection_probability = 0.0;
  double gate_probability = 0.0;  ///< that the gate holds a target's plot
  double clutter_density = 0.0;   ///< plots per km^2

  [[nodiscard]] int tracks() const noexcept { return static_cast<int>(track_row.size()); }
  [[nodiscard]] int plots() const noexcept { return static_cast<int>(plot_row.size()); }
  [[nodiscard]] std::size_t at(int track, int plot) const noexcept {
    return static_cast<std::size_t>(track) * plot_row.size() + static_cast<std::size_t>(plot);
  }
};

/// Three sensors at one instant, seen pair by pair: how far any two reports of different sensors
/// are apart. Sensor s reports in dimension s + 1.
struct SensorView {
  static constexpr int kSensors = 3;

  std::array<std::vector<int>, kSensors> row;  ///< [s][i]: row of the problem of report i
  /// Squared distance of two reports over its variance if one target made them: chi-square, 2
  /// degrees of freedom. [s + t - 1] for the sensors s < t; of reports i and j at
  /// i * reports(t) + j.
  std::array<std::vector<double>, kSensors> distance;

  [[nodiscard]] int reports(int sensor) const noexcept {
    return static_cast<int>(row[static_cast<std::size_t>(sensor)].size());
  }
  /// Of report i of `sensor` and report j of `other`, another one.
  [[nodiscard]] double between(int sensor, int i, int other, int j) const noexcept {
    if (sensor > other) return between(other, j, sensor, i);
    const auto at = static_cast<std::size_t>(i) * row[static_cast<std::size_t>(other)].size() +
                    static_cast<std::size_t>(j);
    return distance[static_cast<std::size_t>(sensor + other - 1)][at];
  }
};

/// The views of one window. Valid as long as what they were made from.
struct Views {
  HypothesisTree tree;
  TupleCost tuple_cost;  ///< empty where only columns are allowed as answers
  std::optional<PairView> pairs = std::nullopt;      ///< of windows of one scan that have it
  std::optional<SensorView> sensors = std::nullopt;  ///< of windows of three sensors, which have no
                                                     ///< tree
};

}  // namespace mda
