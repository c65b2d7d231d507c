#include "algorithms/flow/pair_graph.h"

#include <cstdint>
#include <unordered_map>
#include <utility>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

class PairGraphBuilder {
 public:
  explicit PairGraphBuilder(const AssociationProblem& problem)
      : rows_(problem.rows()), tree_(problem.views()->tree), ending_(index(tree_.scans()) + 1) {}

  PairGraph build() {
    for (int k = 1; k <= tree_.scans(); ++k) add_scan(k);
    return std::move(graph_);
  }

 private:
  /// A pair whose last plot is in a scan to come.
  struct Pending {
    PairNode node;
    std::vector<int> arcs;  ///< that lead to it
  };

  /// Everything that leads to pairs which end in this scan has been followed.
  void add_scan(int scan) {
    for (const Pending& pending : ending_[index(scan)]) {
      for (const int a : pending.arcs) graph_.arcs[index(a)].head = size();
      graph_.nodes.push_back(pending.node);
      follow(size() - 1);
    }
    for (int n = tree_.layer_begin[index(scan) + 1] - 1;
         n >= tree_.layer_begin[index(scan)] && tree_.parent[index(n)] == kNoNode; --n) {
      graph_.nodes.push_back({kNoRow, tree_.row[index(n)], scan, n});
      follow(size() - 1);
    }
  }

  /// Adds the arcs out of node v.
  void follow(int v) {
    const PairNode node = graph_.nodes[index(v)];
    const double until_here = node.before == kNoRow ? 0.0 : tree_.cost[index(node.tree_node)];
    int here = node.tree_node;
    for (int scan = node.scan + 1; scan <= tree_.scans(); ++scan) {
      int missed = kNoNode;
      for (int c = tree_.child_begin[index(here)]; c < tree_.child_end[index(here)]; ++c) {
        if (tree_.row[index(c)] == kNoRow) {
          missed = c;
        } else {
          lead_to({node.last, tree_.row[index(c)], scan, c});
          graph_.arcs.push_back({v, PairArc::kEnd, tree_.cost[index(c)] - until_here});
        }
      }
      if (missed == kNoNode) return;
      here = missed;
    }
    graph_.arcs.push_back({v, PairArc::kEnd, tree_.cost[index(here)] - until_here});
  }

  /// The arc about to be added leads to this pair, by way of this node of the tree.
  void lead_to(const PairNode& pair) {
    const auto key = static_cast<std::int64_t>(pair.before) * rows_ + pair.last;
    auto& ending = ending_[index(pair.scan)];
    const auto [entry, is_new] = number_.try_emplace(key, static_cast<int>(ending.size()));
    if (is_new) ending.push_back({pair, {}});
    Pending& pending = ending[index(entry->second)];
    pending.arcs.push_back(static_cast<int>(graph_.arcs.size()));
    if (tree_.cost[index(pair.tree_node)] < tree_.cost[index(pending.node.tree_node)]) {
      pending.node.tree_node = pair.tree_node;
    }
  }

  [[nodiscard]] int size() const { return static_cast<int>(graph_.nodes.size()); }

  int rows_;
  const HypothesisTree& tree_;
  PairGraph graph_;
  std::vector<std::vector<Pending>> ending_;      ///< per scan
  std::unordered_map<std::int64_t, int> number_;  ///< of a pair, among those ending in its scan
};

}  // namespace

PairGraph pair_graph(const AssociationProblem& problem) {
  return PairGraphBuilder(problem).build();
}

}  // namespace mda
