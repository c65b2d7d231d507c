#include "algorithms/flow/mcf.h"

#include <utility>
#include <vector>

#include "algorithms/backends/run.h"
#include "algorithms/flow/flow_program.h"
#include "algorithms/flow/needs.h"
#include "algorithms/flow/path_decoder.h"
#include "algorithms/flow/path_rounding.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

struct Commodity {
  LayeredGraph graph;
  std::vector<int> variable;  ///< per arc, negative: none
};

class Mcf final : public Associator {
 public:
  explicit Mcf(Integrality integrality) : integrality_(integrality) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .needs_tree = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    return needs_tree_of_known_tracks(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    if (budget.expired()) return no_answer(Outcome::kDeadline);
    const auto graph_start = Clock::now();
    FlowProgram flow(problem);
    std::vector<Commodity> commodities;
    for (LayeredGraph& graph : layered_graphs_by_track(problem, TieRule::kCumulative)) {
      std::vector<int> variable = flow.add(graph);
      commodities.push_back({std::move(graph), std::move(variable)});
    }
    const auto lp_start = Clock::now();
    const double graph_ms = milliseconds_since(graph_start);
    const BinaryResult result = solve_program(flow.program(), integrality_, budget);
    const double lp_ms = milliseconds_since(lp_start);

    Solution solution = no_answer(result.outcome);
    const bool answered = result.outcome == Outcome::kOptimal || !result.x.empty();
    if (answered) {
      const Stop stop = solution.stop;
      solution = decode(problem, commodities, result);
      solution.stop = stop;
    }
    describe(commodities, result, solution.stats);
    solution.stats.graph_ms = graph_ms;
    solution.stats.lp_ms = lp_ms;
    return solution;
  }

 private:
  [[nodiscard]] Solution decode(const AssociationProblem& problem,
                                const std::vector<Commodity>& commodities,
                                const BinaryResult& result) const {
    const bool whole = integrality_ == Integrality::kBinary || result.lp_fractional == 0;
    PathDecoder decoder(problem);
    if (whole) {
      for (const Commodity& one : commodities) {
        const auto flow = flow_of(one.variable, result.x);
        for (const Tuple& tuple : sequences(one.graph, flow)) decoder.follow(tuple);
      }
    } else {
      round(problem, commodities, result.x, decoder);
    }
    return decoder.answer();
  }

  static void round(const AssociationProblem& problem, const std::vector<Commodity>& commodities,
                    const std::vector<double>& x, PathDecoder& decoder) {
    std::vector<WeightedPath> paths;
    for (const Commodity& one : commodities) {
      std::vector<double> flow(one.variable.size(), 0.0);
      for (std::size_t a = 0; a < flow.size(); ++a) {
        if (one.variable[a] >= 0) flow[a] = x[index(one.variable[a])];
      }
      for (WeightedPath& path : paths_of_flow(one.graph, flow)) paths.push_back(std::move(path));
    }
    std::vector<char> served(index(problem.rows()), 0);
    for (const Tuple& tuple : disjoint_paths(std::move(paths), problem.rows())) {
      served[index(tuple.track)] = 1;
      if (!tuple.rows.empty()) decoder.follow(tuple);
    }
    for (const Commodity& one : commodities) {
      const int track = one.graph.nodes.front().row;
      if (served[index(track)] == 0) decoder.coast(track);
    }
  }

  /// The destination is one for all commodities.
  static void describe(const std::vector<Commodity>& commodities, const BinaryResult& result,
                       Stats& stats) {
    int nodes = 1;
    int arcs = 0;
    for (const Commodity& one : commodities) {
      nodes += one.graph.destination();
      arcs += static_cast<int>(one.graph.arcs.size());
    }
    stats.graph_nodes = nodes;
    stats.graph_arcs = arcs;
    stats.lp_fractional = result.lp_fractional;
    stats.iterations = result.iterations;
    stats.nodes = result.nodes;
  }

  Integrality integrality_;
};

}  // namespace

std::unique_ptr<Associator> make_mcf() { return std::make_unique<Mcf>(Integrality::kBinary); }

std::unique_ptr<Associator> make_mcf_lp() { return std::make_unique<Mcf>(Integrality::kRelaxed); }

}  // namespace mda
