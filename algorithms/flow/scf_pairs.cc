#include "algorithms/flow/scf_pairs.h"

#include <utility>
#include <vector>

#include "algorithms/backends/run.h"
#include "algorithms/flow/flow_program.h"
#include "algorithms/flow/needs.h"
#include "algorithms/flow/pair_graph.h"
#include "algorithms/flow/path_decoder.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Adds the flow of births; returns the first arc's variable, the others follow.
int add_births(const PairGraph& graph, FlowProgram& flow) {
  std::vector<int> balance_row(graph.nodes.size(), -1);
  for (std::size_t v = 0; v < graph.nodes.size(); ++v) {
    if (graph.nodes[v].before != kNoRow) balance_row[v] = flow.program().add_row(0.0, 0.0);
  }
  const int first = static_cast<int>(flow.program().costs.size());
  std::vector<BinaryProgram::Entry> entries;
  for (const PairArc& arc : graph.arcs) {
    entries.clear();
    const int tail_row = balance_row[index(arc.tail)];
    if (tail_row >= 0) {
      entries.push_back({tail_row, 1.0});
    } else {
      entries.push_back({flow.capacity_row(graph.nodes[index(arc.tail)].last), 1.0});
    }
    if (arc.head != PairArc::kEnd) {
      entries.push_back({balance_row[index(arc.head)], -1.0});
      entries.push_back({flow.capacity_row(graph.nodes[index(arc.head)].last), 1.0});
    }
    flow.program().add_variable(arc.cost, entries);
  }
  return first;
}

/// Hands over the tracks born in a flow where x[first + a] is that on arc a.
void decode_births(const PairGraph& graph, const std::vector<double>& x, int first, int scans,
                   PathDecoder& decoder) {
  std::vector<int> arc_out(graph.nodes.size(), -1);
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
    if (x[index(first + a)] > 0.5) arc_out[index(graph.arcs[index(a)].tail)] = a;
  }
  for (int birth = 0; birth < static_cast<int>(graph.nodes.size()); ++birth) {
    if (graph.nodes[index(birth)].before != kNoRow || arc_out[index(birth)] < 0) continue;
    std::vector<int> rows(index(scans), kNoRow);
    for (int v = birth; v != PairArc::kEnd; v = graph.arcs[index(arc_out[index(v)])].head) {
      rows[index(graph.nodes[index(v)].scan) - 1] = graph.nodes[index(v)].last;
    }
    decoder.begin(rows);
  }
}

class ScfPairs final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .needs_tree = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    return needs_tree_of_free_tracks(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    if (budget.expired()) return no_answer(Outcome::kDeadline);
    const auto graph_start = Clock::now();
    const LayeredGraph tracks = layered_graph(problem, TieRule::kCumulative);
    const PairGraph births = pair_graph(problem);
    FlowProgram flow(problem);
    const std::vector<int> track_variable = flow.add(tracks);
    const int first_birth_variable = add_births(births, flow);
    const auto lp_start = Clock::now();
    const double graph_ms = milliseconds_since(graph_start);
    const BinaryResult result = solve_program(flow.program(), Integrality::kBinary, budget);
    const double lp_ms = milliseconds_since(lp_start);

    Solution solution = no_answer(result.outcome);
    if (result.outcome == Outcome::kOptimal || !result.x.empty()) {
      const Stop stop = solution.stop;
      PathDecoder decoder(problem);
      for (const Tuple& tuple : sequences(tracks, flow_of(track_variable, result.x))) {
        decoder.follow(tuple);
      }
      decode_births(births, result.x, first_birth_variable, tracks.scans(), decoder);
      solution = decoder.answer();
      solution.stop = stop;
    }
    solution.stats.graph_nodes = tracks.destination() + 1 + static_cast<int>(births.nodes.size());
    solution.stats.graph_arcs = static_cast<int>(tracks.arcs.size() + births.arcs.size());
    solution.stats.graph_ms = graph_ms;
    solution.stats.lp_ms = lp_ms;
    solution.stats.lp_fractional = result.lp_fractional;
    solution.stats.iterations = result.iterations;
    solution.stats.nodes = result.nodes;
    return solution;
  }
};

}  // namespace

std::unique_ptr<Associator> make_scf_pairs() { return std::make_unique<ScfPairs>(); }

}  // namespace mda
