#include "algorithms/flow/viterbi_sequential.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "algorithms/backends/run.h"
#include "algorithms/flow/layered_graph.h"
#include "algorithms/flow/needs.h"
#include "algorithms/flow/path_decoder.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The cheapest ways from every node to the destination past the nodes taken so far.
class Paths {
 public:
  explicit Paths(const LayeredGraph& graph)
      : graph_(graph), taken_(graph.nodes.size(), 0), arc_(graph.nodes.size(), -1) {
    find();
  }

  /// Infinite if there is no way. True of the graph as of the last find(), else a lower bound.
  [[nodiscard]] double cost(int from) const { return cost_[index(from)]; }

  /// Whether the path from here is still free.
  [[nodiscard]] bool is_free(int from) const {
    for (int v = from; v != graph_.destination(); v = next(v)) {
      if (taken_[index(v)] != 0) return false;
    }
    return true;
  }

  /// Heads are after their tails, so one sweep backwards is enough. O(arcs).
  void find() {
    cost_.assign(graph_.nodes.size() + 1, kInfinity);
    cost_.back() = 0.0;
    for (int a = static_cast<int>(graph_.arcs.size()) - 1; a >= 0; --a) {
      const LayeredArc& arc = graph_.arcs[index(a)];
      if (arc.head != graph_.destination() && taken_[index(arc.head)] != 0) continue;
      const double through = arc.cost + cost_[index(arc.head)];
      if (through >= cost_[index(arc.tail)]) continue;
      cost_[index(arc.tail)] = through;
      arc_[index(arc.tail)] = a;
    }
  }

  /// Takes the nodes of the path; adds its arcs to the flow.
  void take(int from, std::vector<std::int64_t>& flow) {
    for (int v = from; v != graph_.destination(); v = next(v)) {
      taken_[index(v)] = 1;
      flow[index(arc_[index(v)])] = 1;
    }
  }

 private:
  [[nodiscard]] int next(int v) const { return graph_.arcs[index(arc_[index(v)])].head; }

  const LayeredGraph& graph_;
  std::vector<char> taken_;
  std::vector<double> cost_;
  std::vector<int> arc_;  ///< the first one of the cheapest way
};

class ViterbiSequential final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .needs_tree = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    return needs_tree_of_known_tracks(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    if (budget.expired()) return no_answer(Outcome::kDeadline);
    const auto start = Clock::now();
    const LayeredGraph graph = layered_graph(problem, TieRule::kCumulative);
    const double graph_ms = milliseconds_since(start);
    PathDecoder decoder(problem);
    follow_paths(graph, decoder);
    Solution solution = decoder.answer();
    solution.stats.graph_ms = graph_ms;
    solution.stats.graph_nodes = graph.destination() + 1;
    solution.stats.graph_arcs = static_cast<int>(graph.arcs.size());
    return solution;
  }

 private:
  /// Costs only rise as nodes are taken, so the least gain is right if its own path is still free.
  static void follow_paths(const LayeredGraph& graph, PathDecoder& decoder) {
    Paths paths(graph);
    std::vector<std::int64_t> flow(graph.arcs.size(), 0);
    std::vector<int> waiting(index(graph.tracks()));
    for (int v = 0; v < graph.tracks(); ++v) waiting[index(v)] = v;
    std::vector<double> missing(waiting.size());
    for (const int v : waiting)
      missing[index(v)] = decoder.coasting_cost(graph.nodes[index(v)].row);
    const auto gains_more = [&](int a, int b) {
      return std::tuple(paths.cost(a) - missing[index(a)], paths.cost(a), a) <
             std::tuple(paths.cost(b) - missing[index(b)], paths.cost(b), b);
    };
    while (!waiting.empty()) {
      const auto best = std::min_element(waiting.begin(), waiting.end(), gains_more);
      if (paths.cost(*best) == kInfinity) break;
      if (!paths.is_free(*best)) {
        paths.find();
        continue;
      }
      paths.take(*best, flow);
      waiting.erase(best);
    }
    for (const Tuple& tuple : sequences(graph, flow)) decoder.follow(tuple);
    for (const int v : waiting) decoder.coast(graph.nodes[index(v)].row);
  }
};

}  // namespace

std::unique_ptr<Associator> make_viterbi_sequential() {
  return std::make_unique<ViterbiSequential>();
}

}  // namespace mda
