// Flows through layered graphs that share plots, as a binary program.
#pragma once

#include <vector>

#include "algorithms/api/problem.h"
#include "algorithms/backends/binary_program.h"
#include "algorithms/flow/layered_graph.h"

namespace mda {

/// Rows: a unit of flow out of every track, flow conservation at every node, every plot used at
/// most once by all graphs together. Variables: the flow on the arcs.
class FlowProgram {
 public:
  explicit FlowProgram(const AssociationProblem& problem);

  /// Adds the flow through one layered graph, whose missed nodes take at most one unit. Returns the
  /// variable of every arc; arcs from the last layer to the destination need none: -1. O(arcs).
  std::vector<int> add(const LayeredGraph& graph);

  /// The row of the program that lets this plot be used at most once.
  [[nodiscard]] int capacity_row(int plot);

  [[nodiscard]] BinaryProgram& program() { return program_; }

 private:
  BinaryProgram program_;
  std::vector<int> capacity_row_;  ///< per row of the problem, -1: not yet
};

/// The whole flow on every arc of a graph whose arcs have these variables.
[[nodiscard]] std::vector<std::int64_t> flow_of(const std::vector<int>& variable,
                                                const std::vector<double>& x);

}  // namespace mda
