#include "algorithms/testing/random_flows.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "algorithms/testing/draw.h"

namespace mda::testing {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Draws one graph. Detections are numbered in the order of time.
class PathFlow {
 public:
  explicit PathFlow(std::uint64_t seed)
      : draw_(seed),
        has_supplies_(seed % 3 != 0),
        has_free_flow_(seed % 3 != 1),
        largest_cost_(draw_.chance(0.4)   ? 4
                      : draw_.chance(0.5) ? 100
                                          : 1'000'000'000) {
    sink_ = add_node();
    if (has_free_flow_) source_ = add_node();
    const int detections = draw_.below(14);
    const double single_share = draw_.chance(0.3) ? 0.5 : 0.0;
    for (int d = 0; d < detections; ++d) add_detection(draw_.chance(single_share));
    add_links();
    add_ends();
    if (has_free_flow_ && draw_.chance(0.3)) add_arc(source_, sink_, 1 + draw_.below(3));
  }

  [[nodiscard]] FlowGraph graph() const {
    FlowGraph graph = graph_;
    graph.source = source_;
    graph.sink = has_free_flow_ ? sink_ : -1;
    return graph;
  }

 private:
  struct Detection {
    int first;
    int last;
    int most_in = 1000;  ///< arcs
    int most_out = 1000;
  };

  int add_node() {
    graph_.supply.push_back(0);
    return graph_.nodes++;
  }

  std::int64_t cost() {
    return draw_.below(2 * largest_cost_ + 1) - largest_cost_ + draw_.below(largest_cost_ + 1) / 2;
  }

  void add_arc(int tail, int head, std::int64_t capacity) {
    graph_.arcs.push_back({tail, head, capacity, cost()});
  }

  void add_detection(bool is_single) {
    Detection detection{add_node(), 0};
    detection.last = detection.first;
    if (has_supplies_ && draw_.chance(0.25)) {
      graph_.supply[index(detection.first)] = 1;
      --graph_.supply[index(sink_)];
      detection.most_in = 0;
    }
    if (is_single) {
      (draw_.chance(0.5) ? detection.most_in : detection.most_out) = detection.most_in == 0 ? 0 : 1;
    }
    for (int own = is_single ? 0 : 1 + draw_.below(2); own > 0; --own) {
      const int next = add_node();
      add_arc(std::exchange(detection.last, next), next, 1);
    }
    detections_.push_back(detection);
  }

  void link(int tail, Detection* from, int head, Detection* to) {
    const bool is_narrow =
        (from != nullptr && from->most_out < 1000) || (to != nullptr && to->most_in < 1000);
    for (int copies = draw_.chance(0.1) ? 2 : 1; copies > 0; --copies) {
      if ((from != nullptr && from->most_out <= 0) || (to != nullptr && to->most_in <= 0)) return;
      if (from != nullptr) --from->most_out;
      if (to != nullptr) --to->most_in;
      const int odd = draw_.below(20);
      add_arc(tail, head, odd == 0 ? 0 : odd == 1 && !is_narrow ? 3 : 1);
    }
  }

  void add_links() {
    const double chance = 0.15 + 0.7 * draw_.unit();
    const int reach = draw_.chance(0.5) ? 4 : 14;
    for (int j = 0; j < static_cast<int>(detections_.size()); ++j) {
      for (int i = std::max(0, j - reach); i < j; ++i) {
        if (!draw_.chance(chance)) continue;
        Detection& from = detections_[index(i)];
        Detection& to = detections_[index(j)];
        link(from.last, &from, to.first, &to);
      }
    }
  }

  void add_ends() {
    const double entry = has_free_flow_ ? (draw_.chance(0.5) ? 1.0 : 0.5) : 0.0;
    const double exit = draw_.chance(0.5) ? 1.0 : 0.4;
    for (Detection& d : detections_) {
      if (draw_.chance(entry)) link(source_, nullptr, d.first, &d);
      if (draw_.chance(exit)) link(d.last, &d, sink_, nullptr);
    }
  }

  Draw draw_;
  bool has_supplies_;
  bool has_free_flow_;
  int largest_cost_;
  int source_ = -1;
  int sink_ = -1;
  FlowGraph graph_;
  std::vector<Detection> detections_;
};

}  // namespace

FlowGraph random_path_flow(std::uint64_t seed) { return reorder(PathFlow(seed).graph(), seed + 1); }

FlowGraph reorder(const FlowGraph& graph, std::uint64_t seed) {
  Draw draw(seed);
  const std::vector<int> number = draw.permutation(graph.nodes);
  FlowGraph other = graph;
  for (int n = 0; n < graph.nodes; ++n) {
    other.supply[index(number[index(n)])] = graph.supply[index(n)];
  }
  const std::vector<int> order = draw.permutation(static_cast<int>(graph.arcs.size()));
  for (std::size_t a = 0; a < order.size(); ++a) {
    FlowArc& arc = other.arcs[a];
    arc = graph.arcs[index(order[a])];
    arc.tail = number[index(arc.tail)];
    arc.head = number[index(arc.head)];
  }
  if (graph.source >= 0) {
    other.source = number[index(graph.source)];
    other.sink = number[index(graph.sink)];
  }
  return other;
}

}  // namespace mda::testing
