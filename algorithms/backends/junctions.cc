#include "algorithms/backends/junctions.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace mda {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

JunctionSplit::JunctionSplit(const FlowGraph& graph) : whole_(graph) {
  find_junctions();
  if (has_junctions()) split();
}

void JunctionSplit::find_junctions() {
  constexpr std::int64_t kMostLinks = std::int64_t{1} << 27;
  std::vector<std::int64_t> in(index(whole_.nodes), 0);
  std::vector<std::int64_t> out(index(whole_.nodes), 0);
  is_junction_.assign(index(whole_.nodes), 1);
  for (const FlowArc& arc : whole_.arcs) {
    if (arc.capacity == 0) continue;
    ++out[index(arc.tail)];
    ++in[index(arc.head)];
    if (arc.capacity == 1) continue;
    is_junction_[index(arc.tail)] = 0;
    is_junction_[index(arc.head)] = 0;
  }
  for (int n = 0; n < whole_.nodes; ++n) {
    const bool is_terminal = n == whole_.source || n == whole_.sink || whole_.supply[index(n)] != 0;
    if (is_terminal || in[index(n)] < 2 || out[index(n)] < 2) is_junction_[index(n)] = 0;
    if (is_junction_[index(n)] != 0) links_ += in[index(n)] * out[index(n)];
  }
  if (links_ > kMostLinks) links_ = 0;
}

void JunctionSplit::split() {
  split_ = {whole_.nodes, whole_.supply, whole_.arcs, whole_.source, whole_.sink};
  std::vector<std::vector<int>> ends_in(index(whole_.nodes));
  std::vector<std::vector<int>> ends_out(index(whole_.nodes));
  for (FlowArc& arc : split_.arcs) {
    if (arc.capacity == 0) continue;
    if (is_junction_[index(arc.tail)] != 0) {
      ends_out[index(arc.tail)].push_back(split_.nodes);
      junction_of_end_.push_back(arc.tail);
      arc.tail = split_.nodes++;
    }
    if (is_junction_[index(arc.head)] != 0) {
      ends_in[index(arc.head)].push_back(split_.nodes);
      junction_of_end_.push_back(arc.head);
      arc.head = split_.nodes++;
    }
  }
  split_.supply.resize(index(split_.nodes), 0);
  split_.arcs.reserve(split_.arcs.size() + static_cast<std::size_t>(links_));
  for (int n = 0; n < whole_.nodes; ++n) {
    for (const int from : ends_in[index(n)]) {
      for (const int to : ends_out[index(n)]) split_.arcs.push_back({from, to, 1, 0});
    }
  }
}

/// Where units pass a junction, the ends they use have one potential, those of other arcs out at
/// most that, and those of other arcs in at least that: so the largest of the arcs out fits all.
FlowResult JunctionSplit::joined(FlowResult result) const {
  if (result.reason_node >= whole_.nodes) {
    result.reason_node = junction_of_end_[index(result.reason_node - whole_.nodes)];
  }
  if (result.outcome != FlowOutcome::kOptimal) return result;
  result.flow.resize(whole_.arcs.size());
  std::vector<std::int64_t> potential(result.potential.begin(),
                                      result.potential.begin() + whole_.nodes);
  for (int n = 0; n < whole_.nodes; ++n) {
    if (is_junction_[index(n)] != 0) potential[index(n)] = INT64_MIN;
  }
  for (std::size_t a = 0; a < whole_.arcs.size(); ++a) {
    const int tail = whole_.arcs[a].tail;
    if (whole_.arcs[a].capacity == 0 || is_junction_[index(tail)] == 0) continue;
    potential[index(tail)] =
        std::max(potential[index(tail)], result.potential[index(split_.arcs[a].tail)]);
  }
  result.potential = std::move(potential);
  return result;
}

}  // namespace mda
