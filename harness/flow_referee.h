// Judges answers to flow problems without any code's word.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "algorithms/api/flow.h"
#include "harness/flow_file.h"

namespace mda {

struct FlowVerdict {
  std::string refutation;  ///< why the answer is wrong, in one sentence; empty if it is not
  /// Of the flow, in the units of the file and summed in double from its own costs; nothing without
  /// a flow that fits the graph. The same for every order of the lines.
  std::optional<double> cost;
  /// Units that leave the sources for the sinks; nothing without a cost.
  std::optional<std::int64_t> paths;
  /// A lower bound on the cost of every flow, from the answer's potentials and the file's own
  /// costs; nothing if they certify none.
  std::optional<double> certified_bound;
};

/// An answer is refuted if its flow breaks a capacity or gets lost, if it claims an optimum that
/// its potentials (where it gives any) do not certify, or if it finds infeasible what is solved by
/// no flow at all. That supplies cannot be met is taken from the code otherwise.
/// O(arcs log arcs). Throws std::overflow_error if the cost is outside 64 bits.
[[nodiscard]] FlowVerdict judge_flow(const FlowFile& file, const FlowResult& result);

}  // namespace mda
