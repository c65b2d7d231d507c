#include "algorithms/flow/path_rounding.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// What a basic solution leaves of a flow after subtracting paths, but for rounding errors.
constexpr double kNoFlow = 1e-6;

class Splitter {
 public:
  Splitter(const LayeredGraph& graph, const std::vector<double>& flow)
      : graph_(graph), left_(flow), arc_begin_(graph.nodes.size() + 1, 0) {
    for (const LayeredArc& arc : graph.arcs) ++arc_begin_[index(arc.tail) + 1];
    for (std::size_t v = 1; v < arc_begin_.size(); ++v) arc_begin_[v] += arc_begin_[v - 1];
  }

  std::vector<WeightedPath> paths() {
    std::vector<WeightedPath> found;
    for (;;) {
      WeightedPath path = take_path();
      if (path.weight <= kNoFlow) return found;
      found.push_back(std::move(path));
    }
  }

 private:
  /// The path's weight is 0 when nothing is left.
  WeightedPath take_path() {
    WeightedPath path;
    path.weight = 1.0;
    path.tuple.track = graph_.nodes.front().row;
    std::vector<int> arcs;
    const int last_layer = graph_.layer_begin[index(graph_.scans())];
    for (int v = 0; v < last_layer; v = graph_.arcs[index(arcs.back())].head) {
      const int a = widest_arc(v);
      if (a < 0) return {};
      arcs.push_back(a);
      path.weight = std::min(path.weight, left_[index(a)]);
      path.cost += graph_.arcs[index(a)].cost;
      const int head = graph_.arcs[index(a)].head;
      if (head == graph_.destination()) break;
      const LayeredNode& node = graph_.nodes[index(head)];
      path.tuple.rows.push_back(node.plot ? node.row : kNoRow);
    }
    for (const int a : arcs) left_[index(a)] -= path.weight;
    return path;
  }

  [[nodiscard]] int widest_arc(int v) const {
    int best = -1;
    for (int a = arc_begin_[index(v)]; a < arc_begin_[index(v) + 1]; ++a) {
      if (left_[index(a)] <= kNoFlow) continue;
      const double more = best < 0 ? 1.0 : left_[index(a)] - left_[index(best)];
      const bool cheaper = best >= 0 && graph_.arcs[index(a)].cost < graph_.arcs[index(best)].cost;
      if (more > kNoFlow || (more >= -kNoFlow && cheaper)) best = a;
    }
    return best;
  }

  const LayeredGraph& graph_;
  std::vector<double> left_;
  std::vector<int> arc_begin_;  ///< first arc out of every node
};

}  // namespace

std::vector<WeightedPath> paths_of_flow(const LayeredGraph& graph,
                                        const std::vector<double>& flow) {
  return Splitter(graph, flow).paths();
}

std::vector<Tuple> disjoint_paths(std::vector<WeightedPath> paths, int rows) {
  const auto rank = [](const WeightedPath& path) {
    return std::tuple(-std::llround(path.weight / kNoFlow), path.cost, path.tuple.track);
  };
  std::stable_sort(paths.begin(), paths.end(),
                   [&](const WeightedPath& a, const WeightedPath& b) { return rank(a) < rank(b); });
  std::vector<char> used(index(rows), 0);
  std::vector<Tuple> taken;
  for (WeightedPath& path : paths) {
    std::vector<int> needs = {path.tuple.track};
    std::copy_if(path.tuple.rows.begin(), path.tuple.rows.end(), std::back_inserter(needs),
                 [](int row) { return row != kNoRow; });
    if (std::any_of(needs.begin(), needs.end(), [&](int row) { return used[index(row)] != 0; })) {
      continue;
    }
    for (const int row : needs) used[index(row)] = 1;
    taken.push_back(std::move(path.tuple));
  }
  return taken;
}

}  // namespace mda
