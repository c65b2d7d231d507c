// A flow in which no inner node carries more than one unit, as a one-sided assignment.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/api/flow.h"
#include "algorithms/backends/one_sided.h"

namespace mda {

/// Detections are the longest chains of inner nodes that can only be passed one after another. Each
/// chooses what comes before it: the source, another detection, or itself, which says that no path
/// uses it. So detection j is agent j and, as what others choose, object j:
///   alone_j = cost of the arc from the source,  unused_j = cost of the arc to the sink,
///   cost(j, i) = cost of the link from i,  cost(j, j) = -cost of j's own arcs.
/// Without cycles nothing but a detection itself can close a cycle of choices. The duals give
/// node potentials: u_j at j's first node, -q_j at its last, 0 at source and sink.
/// Links that cost no less than leaving one detection for the sink and entering the other from the
/// source are left out: the optimum and the potentials stay what they are. Detections are numbered
/// so that what a detection chooses from comes before it.
class PathReduction {
 public:
  /// Two passes over the arcs; more, and a sorting of the detections in linear time, if the nodes
  /// are not numbered in the order of time. The graph must outlive the reduction.
  explicit PathReduction(const FlowGraph& graph);

  /// Why this is not such a graph; empty if it is one.
  [[nodiscard]] const std::string& fault() const noexcept { return fault_; }
  /// The node that the fault is about, or -1.
  [[nodiscard]] int fault_node() const noexcept { return fault_node_; }
  [[nodiscard]] const OneSidedProblem& problem() const noexcept { return problem_; }
  /// A hundredth of what it costs on average to start or to end a path, at least 1: an increment of
  /// prices that is small against what choices decide.
  [[nodiscard]] std::int64_t small_step() const;
  /// Whether some detection can start no path, or end none.
  [[nodiscard]] bool lacks_ends() const noexcept { return lacks_ends_; }

  /// The flow and potentials of a matched problem. Infeasible if a path starts or ends where there
  /// is no arc.
  [[nodiscard]] FlowResult result(const OneSidedMatcher& matcher) const;

 private:
  /// What the arcs say about a node. Capacities count up to 2.
  struct Node {
    std::int32_t in = 0;       ///< sum of the capacities of the arcs in
    std::int32_t out = 0;      ///< of the arcs out
    std::int32_t in_arc = -1;  ///< the last one, as are the others
    std::int32_t out_arc = -1;
    std::int32_t entry_arc = -1;  ///< the cheapest from the source
    std::int32_t exit_arc = -1;   ///< the cheapest to the sink
  };
  struct Detection {
    std::int32_t first;
    std::int32_t last;
    std::int64_t own_cost;  ///< of the arcs between them
  };

  [[nodiscard]] bool is_inner(int node) const { return node != graph_.source && node != sink_; }
  [[nodiscard]] const FlowArc& arc(std::int32_t a) const {
    return graph_.arcs[static_cast<std::size_t>(a)];
  }
  [[nodiscard]] Node& node(int n) { return nodes_[static_cast<std::size_t>(n)]; }
  [[nodiscard]] const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  [[nodiscard]] bool has_supply(int n) const {
    return is_inner(n) && graph_.supply[static_cast<std::size_t>(n)] != 0;
  }
  [[nodiscard]] int detection_of(int n) const { return detection_of_[static_cast<std::size_t>(n)]; }
  /// The arc by which a chain goes on from a node, or -1.
  [[nodiscard]] std::int32_t chain_arc(int n) const;
  [[nodiscard]] bool is_chain_arc(const FlowArc& a) const {
    return node(a.tail).out == 1 && node(a.head).in == 1;
  }

  /// False, after taking down the fault.
  bool refuse(std::string why, int node = -1);
  bool find_sink();
  bool read_arcs();
  bool check_numbers(std::int64_t largest_cost);
  bool check_nodes();
  bool find_detections();
  void add_detection(int first);
  bool order_detections();
  [[nodiscard]] bool is_link(const FlowArc& a) const;
  [[nodiscard]] std::vector<std::int32_t> in_time_order(std::vector<std::int32_t>& before) const;
  void renumber(const std::vector<std::int32_t>& order);
  void add_rows();
  void add_row(std::int32_t number);
  void add_links();
  [[nodiscard]] int first_node_of_a_cycle(const std::vector<std::int32_t>& before) const;

  void carry(int detection, std::vector<std::int64_t>& flow) const;
  [[nodiscard]] bool route(const OneSidedMatcher& matcher, std::vector<std::int64_t>& flow) const;
  void set_potentials(int detection, std::int64_t at_entry, std::int64_t at_exit,
                      std::vector<std::int64_t>& potential) const;

  const FlowGraph& graph_;
  /// Detections choose what comes after them instead: agents and objects change sides. For graphs
  /// with supplies: the prices that agents set for themselves are then distances to the sink, and
  /// only the supplies are left to find a way; from the other side, all ends would compete for the
  /// few starts.
  bool chooses_next_ = false;
  bool ascends_ = true;  ///< arcs between inner nodes go to larger numbers
  bool lacks_ends_ = false;
  int sink_ = -1;  ///< where paths end: the graph's sink or its one node of demand
  /// Cost of a start or an end for which there is no arc: more than any two flows can differ by.
  std::int64_t missing_ = 0;
  std::vector<Node> nodes_;
  std::vector<Detection> detections_;
  std::vector<std::int32_t> detection_of_;  ///< per node; -1 for source and sink
  OneSidedProblem problem_;
  std::string fault_;
  int fault_node_ = -1;
};

}  // namespace mda
