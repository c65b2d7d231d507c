// The order of time among detections, for nodes that are numbered in any order.
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "algorithms/backends/path_reduction.h"

namespace mda {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool PathReduction::is_link(const FlowArc& a) const {
  return a.capacity > 0 && detection_of(a.tail) >= 0 && detection_of(a.head) >= 0 &&
         !is_chain_arc(a);
}

/// Removes detections that nothing links to, again and again; what stays is on a cycle or behind
/// one, and going back from there ends on one. `before`: per detection, how many links come from
/// detections that were not removed.
std::vector<std::int32_t> PathReduction::in_time_order(std::vector<std::int32_t>& before) const {
  std::vector<std::int32_t> begin(detections_.size() + 1);
  for (const FlowArc& a : graph_.arcs) {
    if (!is_link(a)) continue;
    ++before[index(detection_of(a.head))];
    ++begin[index(detection_of(a.tail)) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::int32_t> fill(begin.begin(), begin.end() - 1);
  std::vector<std::int32_t> after(index(begin.back()));
  for (const FlowArc& a : graph_.arcs) {
    if (is_link(a)) after[index(fill[index(detection_of(a.tail))]++)] = detection_of(a.head);
  }
  std::vector<std::int32_t> done;
  for (std::size_t d = 0; d < before.size(); ++d) {
    if (before[d] == 0) done.push_back(static_cast<std::int32_t>(d));
  }
  for (std::size_t next = 0; next < done.size(); ++next) {
    const auto from = index(done[next]);
    for (auto i = index(begin[from]); i < index(begin[from + 1]); ++i) {
      if (--before[index(after[i])] == 0) done.push_back(after[i]);
    }
  }
  return done;
}

int PathReduction::first_node_of_a_cycle(const std::vector<std::int32_t>& before) const {
  std::vector<std::int32_t> previous(before.size(), -1);
  for (const FlowArc& a : graph_.arcs) {
    if (!is_link(a)) continue;
    const int from = detection_of(a.tail);
    const int to = detection_of(a.head);
    if (before[index(from)] > 0 && before[index(to)] > 0) previous[index(to)] = from;
  }
  auto here = static_cast<int>(
      std::find_if(before.begin(), before.end(), [](std::int32_t links) { return links > 0; }) -
      before.begin());
  for (std::size_t step = 0; step < before.size(); ++step) here = previous[index(here)];
  return detections_[index(here)].first;
}

/// Agents that choose in the order of time find the prices of what they choose from settled.
bool PathReduction::order_detections() {
  if (ascends_) return true;
  bool is_ordered = true;
  for (const FlowArc& a : graph_.arcs) {
    if (!is_link(a)) continue;
    const int from = detection_of(a.tail);
    const int to = detection_of(a.head);
    is_ordered = is_ordered && (chooses_next_ ? from > to : from < to);
  }
  if (is_ordered) return true;
  std::vector<std::int32_t> before(detections_.size());
  std::vector<std::int32_t> order = in_time_order(before);
  if (order.size() < detections_.size()) {
    return refuse("a node is on a cycle", first_node_of_a_cycle(before));
  }
  if (chooses_next_) std::reverse(order.begin(), order.end());
  renumber(order);
  return true;
}

void PathReduction::renumber(const std::vector<std::int32_t>& order) {
  std::vector<Detection> ordered;
  std::vector<std::int32_t> number(order.size());
  ordered.reserve(order.size());
  for (const std::int32_t old : order) {
    number[index(old)] = static_cast<std::int32_t>(ordered.size());
    ordered.push_back(detections_[index(old)]);
  }
  detections_ = std::move(ordered);
  for (std::int32_t& d : detection_of_) {
    if (d >= 0) d = number[index(d)];
  }
}

}  // namespace mda
