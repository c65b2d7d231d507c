#include "algorithms/flow/layered_graph.h"

#include <algorithm>
#include <cmath>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// An arc into the layer under construction.
struct Incoming {
  int tail = -1;
  int child = kNoNode;  ///< of the tail's representative
  double cost = 0.0;
};

class LayeredGraphBuilder {
 public:
  LayeredGraphBuilder(const AssociationProblem& problem, TieRule rule)
      : problem_(problem),
        tree_(problem.views()->tree),
        rule_(rule),
        best_(index(problem.rows())),
        best_missed_(index(problem.rows())),
        number_(index(problem.rows())) {}

  /// Of the fixed tracks whose nodes in layer 0 of the tree are first, ..., last - 1.
  LayeredGraph build(int first, int last) {
    graph_ = {};
    graph_.layer_begin.push_back(0);
    for (int n = first; n < last; ++n) {
      graph_.nodes.push_back({tree_.row[index(n)], false, n, tree_.row[index(n)], 0.0});
    }
    std::sort(graph_.nodes.begin(), graph_.nodes.end(),
              [](const LayeredNode& a, const LayeredNode& b) { return a.row < b.row; });
    graph_.layer_begin.push_back(graph_.destination());
    for (int k = 1; k <= tree_.scans(); ++k) add_layer(k);
    add_ways_out();
    return std::move(graph_);
  }

 private:
  void add_layer(int scan) {
    const std::size_t first_arc = graph_.arcs.size();
    reached_.clear();
    for (int v = graph_.layer_begin[index(scan) - 1]; v < graph_.layer_begin[index(scan)]; ++v) {
      follow(v);
    }
    // Of a layer's nodes, the row says which: a track's stands for its missed node.
    std::sort(reached_.begin(), reached_.end(), [&](int a, int b) {
      const bool a_is_plot = is_plot(a);
      const bool b_is_plot = is_plot(b);
      return a_is_plot != b_is_plot ? b_is_plot : a < b;
    });
    for (const int row : reached_) {
      number_[index(row)] = graph_.destination();
      graph_.nodes.push_back(node_of(row));
      best_[index(row)] = {};
      best_missed_[index(row)] = {};
    }
    for (std::size_t a = first_arc; a < graph_.arcs.size(); ++a) {
      graph_.arcs[a].head = number_[index(graph_.arcs[a].head)];
    }
    graph_.layer_begin.push_back(graph_.destination());
  }

  /// Adds the arcs out of v, for the time being with a row as their head.
  void follow(int v) {
    const LayeredNode& node = graph_.nodes[index(v)];
    for (int child = tree_.child_begin[index(node.tree_node)];
         child < tree_.child_end[index(node.tree_node)]; ++child) {
      const bool missed = tree_.row[index(child)] == kNoRow;
      const int row = missed ? node.miss_row : tree_.row[index(child)];
      const Incoming arc{v, child, tree_.step[index(child)]};
      graph_.arcs.push_back({v, row, arc.cost});
      if (best_[index(row)].tail < 0) reached_.push_back(row);
      keep_better(arc, best_[index(row)]);
      if (!node.plot) keep_better(arc, best_missed_[index(row)]);
    }
  }

  void keep_better(const Incoming& arc, Incoming& best) const {
    if (best.tail < 0 || arc.cost < best.cost || (arc.cost == best.cost && wins_tie(arc, best))) {
      best = arc;
    }
  }

  /// Tails come in the order of their numbers, so that `best` has the lower one.
  [[nodiscard]] bool wins_tie(const Incoming& arc, const Incoming& best) const {
    const LayeredNode& tail = graph_.nodes[index(arc.tail)];
    const LayeredNode& best_tail = graph_.nodes[index(best.tail)];
    if (rule_ == TieRule::kLiteral && tail.plot != best_tail.plot) return best_tail.plot;
    return tail.cumulative < best_tail.cumulative;
  }

  [[nodiscard]] LayeredNode node_of(int row) const {
    const Incoming& best = best_[index(row)];
    LayeredNode node;
    node.row = row;
    node.plot = is_plot(row);
    node.tree_node = best.child;
    node.cumulative = graph_.nodes[index(best.tail)].cumulative + best.cost;
    if (!node.plot) {
      node.miss_row = row;
    } else if (const Incoming& missed = best_missed_[index(row)]; missed.tail >= 0) {
      node.miss_row = graph_.nodes[index(missed.tail)].row;
    } else {
      node.miss_row = tree_.track[index(best.child)];
    }
    return node;
  }

  void add_ways_out() {
    for (LayeredArc& arc : graph_.arcs) {
      if (arc.tail >= graph_.tracks()) break;
      arc.cost += tree_.cost[index(graph_.nodes[index(arc.tail)].tree_node)];
    }
    const std::size_t arcs = graph_.arcs.size();
    for (int v = 0; v < graph_.tracks(); ++v) {
      if (problem_.use(graph_.nodes[index(v)].row) == RowUse::kAtMostOnce) {
        graph_.arcs.push_back({v, graph_.destination(), 0.0});
      }
    }
    const auto by_tail = [](const LayeredArc& a, const LayeredArc& b) { return a.tail < b.tail; };
    std::inplace_merge(graph_.arcs.begin(), graph_.arcs.begin() + static_cast<std::ptrdiff_t>(arcs),
                       graph_.arcs.end(), by_tail);
    for (int v = graph_.layer_begin[index(graph_.scans())]; v < graph_.destination(); ++v) {
      graph_.arcs.push_back({v, graph_.destination(), 0.0});
    }
  }

  [[nodiscard]] bool is_plot(int row) const { return problem_.dimension(row) != 0; }

  const AssociationProblem& problem_;
  const HypothesisTree& tree_;
  TieRule rule_;
  LayeredGraph graph_;
  std::vector<int> reached_;           ///< rows of the layer under construction
  std::vector<Incoming> best_;         ///< per row: j*
  std::vector<Incoming> best_missed_;  ///< per row: l*, the same without plots as tails
  std::vector<int> number_;            ///< per row: its node in the newest layer that has one
};

/// Units per nat.
double scale_of(const LayeredGraph& graph, int nodes) {
  constexpr int kFinest = 30;
  constexpr int kCoarsest = 20;
  double largest = 0.0;
  for (const LayeredArc& arc : graph.arcs) largest = std::max(largest, std::abs(arc.cost));
  FlowGraph probe;
  probe.nodes = nodes;
  for (int power = kFinest; power > kCoarsest; --power) {
    const double scaled = std::ldexp(largest, power);
    if (scaled > 0x1.0p62) continue;
    probe.arcs = {{0, 0, 1, std::llround(scaled)}};
    if (fits_flow_codes(probe)) return std::ldexp(1.0, power);
  }
  return std::ldexp(1.0, kCoarsest);
}

}  // namespace

LayeredGraph layered_graph(const AssociationProblem& problem, TieRule rule) {
  const HypothesisTree& tree = problem.views()->tree;
  return LayeredGraphBuilder(problem, rule).build(tree.layer_begin[0], tree.layer_begin[1]);
}

std::vector<LayeredGraph> layered_graphs_by_track(const AssociationProblem& problem, TieRule rule) {
  const HypothesisTree& tree = problem.views()->tree;
  LayeredGraphBuilder builder(problem, rule);
  std::vector<LayeredGraph> graphs;
  for (int n = tree.layer_begin[0]; n < tree.layer_begin[1]; ++n) {
    graphs.push_back(builder.build(n, n + 1));
  }
  return graphs;
}

FlowGraph flow_graph(const LayeredGraph& graph) {
  const int tracks = graph.tracks();
  const int destination = 2 * graph.destination() - tracks;
  const auto entrance = [&](int v) { return v < tracks ? v : 2 * v - tracks; };
  const auto exit = [&](int v) { return v < tracks ? v : 2 * v - tracks + 1; };
  FlowGraph flow;
  flow.nodes = destination + 1;
  flow.supply.assign(index(flow.nodes), 0);
  std::fill_n(flow.supply.begin(), tracks, 1);
  flow.supply[index(destination)] = -tracks;
  const double scale = scale_of(graph, flow.nodes);
  flow.arcs.reserve(graph.arcs.size() + graph.nodes.size());
  for (const LayeredArc& arc : graph.arcs) {
    flow.arcs.push_back({exit(arc.tail), entrance(arc.head), 1, std::llround(arc.cost * scale)});
  }
  for (int v = tracks; v < graph.destination(); ++v) {
    flow.arcs.push_back({entrance(v), exit(v), 1, 0});
  }
  return flow;
}

std::vector<Tuple> sequences(const LayeredGraph& graph, const std::vector<std::int64_t>& flow) {
  std::vector<int> next(graph.nodes.size(), graph.destination());
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    if (flow[a] > 0) next[index(graph.arcs[a].tail)] = graph.arcs[a].head;
  }
  std::vector<Tuple> tuples;
  for (int start = 0; start < graph.tracks(); ++start) {
    Tuple tuple;
    tuple.track = graph.nodes[index(start)].row;
    for (int v = next[index(start)]; v != graph.destination(); v = next[index(v)]) {
      const LayeredNode& node = graph.nodes[index(v)];
      tuple.rows.push_back(node.plot ? node.row : kNoRow);
    }
    if (!tuple.rows.empty()) tuples.push_back(std::move(tuple));
  }
  return tuples;
}

}  // namespace mda
