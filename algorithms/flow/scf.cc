#include "algorithms/flow/scf.h"

#include <utility>

#include "algorithms/backends/run.h"
#include "algorithms/flow/needs.h"
#include "algorithms/flow/path_decoder.h"

namespace mda {
namespace {

class Scf final : public Associator {
 public:
  Scf(const ScfOptions& options, SolveFlow code) : options_(options), code_(code) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .needs_tree = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    return needs_tree_of_known_tracks(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    if (budget.expired()) return no_answer(Outcome::kDeadline);
    const auto start = Clock::now();
    const LayeredGraph graph = layered_graph(problem, options_.tie_rule);
    const FlowGraph flow_problem = flow_graph(graph);
    const double graph_ms = milliseconds_since(start);
    FlowResult flow = code_(flow_problem);
    Solution solution;
    if (flow.outcome == FlowOutcome::kOptimal) {
      PathDecoder decoder(problem);
      for (const Tuple& tuple : sequences(graph, flow.flow)) decoder.follow(tuple);
      solution = decoder.answer();
    } else {
      solution.note = flow.outcome == FlowOutcome::kDeclined
                          ? std::move(flow.reason)
                          : "no set of disjoint paths leads every track to the end";
    }
    solution.stats.graph_ms = graph_ms;
    solution.stats.lp_fractional = flow.lp_fractional;
    solution.stats.graph_nodes = graph.destination() + 1;
    solution.stats.graph_arcs = static_cast<int>(graph.arcs.size());
    return solution;
  }

 private:
  ScfOptions options_;
  SolveFlow code_;
};

}  // namespace

std::unique_ptr<Associator> make_scf(const ScfOptions& options, SolveFlow code) {
  return std::make_unique<Scf>(options, code);
}

}  // namespace mda
