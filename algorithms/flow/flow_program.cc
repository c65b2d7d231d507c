#include "algorithms/flow/flow_program.h"

#include <limits>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kNoVariable = -1;

}  // namespace

FlowProgram::FlowProgram(const AssociationProblem& problem)
    : capacity_row_(index(problem.rows()), -1) {}

int FlowProgram::capacity_row(int plot) {
  int& row = capacity_row_[index(plot)];
  if (row < 0) row = program_.add_row(-kInfinity, 1.0);
  return row;
}

std::vector<int> FlowProgram::add(const LayeredGraph& graph) {
  const int last_layer = graph.layer_begin[index(graph.scans())];
  const int first_row = static_cast<int>(program_.row_lower.size());
  const auto balance_row = [&](int v) { return first_row + v; };
  for (int v = 0; v < last_layer; ++v) {
    const double out_of_here = v < graph.tracks() ? 1.0 : 0.0;
    program_.add_row(out_of_here, out_of_here);
  }
  std::vector<int> missed_row(graph.nodes.size(), -1);
  for (int v = graph.tracks(); v < graph.destination(); ++v) {
    // The unit of a lone track cannot come to a node twice.
    if (graph.nodes[index(v)].plot || graph.tracks() == 1) continue;
    missed_row[index(v)] = program_.add_row(-kInfinity, 1.0);
  }

  std::vector<int> variable;
  std::vector<BinaryProgram::Entry> entries;
  for (const LayeredArc& arc : graph.arcs) {
    if (arc.tail >= last_layer) {
      variable.push_back(kNoVariable);
      continue;
    }
    entries.assign(1, {balance_row(arc.tail), 1.0});
    if (arc.head < last_layer) entries.push_back({balance_row(arc.head), -1.0});
    if (arc.head != graph.destination()) {
      const LayeredNode& head = graph.nodes[index(arc.head)];
      const int once = head.plot ? capacity_row(head.row) : missed_row[index(arc.head)];
      if (once >= 0) entries.push_back({once, 1.0});
    }
    variable.push_back(program_.add_variable(arc.cost, entries));
  }
  return variable;
}

std::vector<std::int64_t> flow_of(const std::vector<int>& variable, const std::vector<double>& x) {
  std::vector<std::int64_t> flow(variable.size(), 0);
  for (std::size_t a = 0; a < variable.size(); ++a) {
    if (variable[a] != kNoVariable && x[index(variable[a])] > 0.5) flow[a] = 1;
  }
  return flow;
}

}  // namespace mda
