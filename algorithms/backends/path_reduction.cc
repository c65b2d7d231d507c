#include "algorithms/backends/path_reduction.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mda {
namespace {

/// Of a node that belongs to no detection yet; source and sink belong to none.
constexpr std::int32_t kUnnumbered = -2;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Two is as good as any larger capacity: more than a path needs.
std::int32_t capped(std::int64_t capacity) {
  return static_cast<std::int32_t>(std::min<std::int64_t>(capacity, 2));
}

}  // namespace

PathReduction::PathReduction(const FlowGraph& graph) : graph_(graph) {
  if (!find_sink() || !read_arcs() || !check_nodes() || !find_detections() || !order_detections()) {
    return;
  }
  add_rows();
  add_links();
}

bool PathReduction::refuse(std::string why, int node) {
  fault_ = std::move(why);
  fault_node_ = node;
  return false;
}

bool PathReduction::find_sink() {
  sink_ = graph_.sink;
  for (int n = 0; n < graph_.nodes; ++n) {
    const std::int64_t supply = graph_.supply[index(n)];
    if (supply < 0 && sink_ < 0) sink_ = n;
    if (supply > 0) chooses_next_ = true;
    if ((supply < 0 && n != sink_) || supply > 1 || (supply != 0 && n == graph_.source)) {
      return refuse("a node has a supply of " + std::to_string(supply) +
                        ", but only supplies of 1 and one node of demand can be used",
                    n);
    }
  }
  return true;
}

/// The first pass over the arcs.
bool PathReduction::read_arcs() {
  constexpr std::size_t kMostArcs = std::size_t{1} << 29;  // sums of capped capacities fit 32 bits
  if (graph_.arcs.size() > kMostArcs) {
    return refuse("it has too many arcs for 32-bit numbers");
  }
  nodes_.resize(index(graph_.nodes));
  std::int64_t least = 0;
  std::int64_t most = 0;
  for (std::size_t a = 0; a < graph_.arcs.size(); ++a) {
    const FlowArc& here = graph_.arcs[a];
    if (here.capacity == 0) continue;
    const auto number = static_cast<std::int32_t>(a);
    least = std::min(least, here.cost);
    most = std::max(most, here.cost);
    Node& tail = node(here.tail);
    Node& head = node(here.head);
    ascends_ = ascends_ && (here.tail < here.head || !is_inner(here.tail) || !is_inner(here.head));
    const std::int32_t units = capped(here.capacity);
    tail.out += units;
    tail.out_arc = number;
    head.in += units;
    head.in_arc = number;
    if (here.tail == graph_.source &&
        (head.entry_arc < 0 || here.cost < arc(head.entry_arc).cost)) {
      head.entry_arc = number;
    }
    if (here.head == sink_ && (tail.exit_arc < 0 || here.cost < arc(tail.exit_arc).cost)) {
      tail.exit_arc = number;
    }
  }
  return check_numbers(std::max(most, least == INT64_MIN ? INT64_MAX : -least));
}

/// A flow uses at most one arc into and one arc out of every node, so two flows differ by less than
/// four times nodes x largest cost; prices stay below four times `missing_`, and sums of eight fit.
bool PathReduction::check_numbers(std::int64_t largest_cost) {
  const std::int64_t nodes = std::int64_t{graph_.nodes} + 1;
  if (largest_cost > INT64_MAX / 128 / nodes) {
    return refuse("its costs are too large for 64 bits");
  }
  missing_ = 4 * nodes * largest_cost + 1;
  return true;
}

bool PathReduction::check_nodes() {
  if (graph_.source >= 0 && node(graph_.source).in > 0) {
    return refuse("the source has an arc in", graph_.source);
  }
  if (sink_ >= 0 && node(sink_).out > 0) {
    return refuse("the sink has an arc out", sink_);
  }
  for (int n = 0; n < graph_.nodes; ++n) {
    if (!is_inner(n)) continue;
    if (has_supply(n) && node(n).in > 0) {
      return refuse("a node has a supply and an arc in", n);
    }
    if (node(n).in > 1 && node(n).out > 1) {
      return refuse("a node can carry more than one unit", n);
    }
  }
  return true;
}

std::int32_t PathReduction::chain_arc(int n) const {
  if (node(n).out != 1) return -1;
  const int head = arc(node(n).out_arc).head;
  return is_inner(head) && node(head).in == 1 ? node(n).out_arc : -1;
}

/// In the order of their first nodes, or against it.
bool PathReduction::find_detections() {
  detection_of_.assign(index(graph_.nodes), kUnnumbered);
  if (graph_.source >= 0) detection_of_[index(graph_.source)] = -1;
  if (sink_ >= 0) detection_of_[index(sink_)] = -1;
  for (int i = 0; i < graph_.nodes; ++i) {
    const int n = chooses_next_ ? graph_.nodes - 1 - i : i;
    if (!is_inner(n)) continue;
    const bool goes_on = node(n).in == 1 && is_inner(arc(node(n).in_arc).tail) &&
                         node(arc(node(n).in_arc).tail).out == 1;
    if (!goes_on) add_detection(n);
  }
  const auto missed = std::find(detection_of_.begin(), detection_of_.end(), kUnnumbered);
  if (missed == detection_of_.end()) return true;
  return refuse("a node is on a cycle", static_cast<int>(missed - detection_of_.begin()));
}

void PathReduction::add_detection(int first) {
  const auto number = static_cast<std::int32_t>(detections_.size());
  std::int64_t own_cost = 0;
  int last = first;
  for (;;) {
    detection_of_[index(last)] = number;
    const std::int32_t next = chain_arc(last);
    if (next < 0) break;
    own_cost += arc(next).cost;
    last = arc(next).head;
  }
  detections_.push_back({first, last, own_cost});
}

void PathReduction::add_rows() {
  problem_.choices.reserve(graph_.arcs.size() + nodes_.size());
  for (std::size_t d = 0; d < detections_.size(); ++d) add_row(static_cast<std::int32_t>(d));
}

void PathReduction::add_row(std::int32_t number) {
  const Detection& here = detections_[index(number)];
  const auto cost_of_end = [&](std::int32_t a) {
    lacks_ends_ = lacks_ends_ || a < 0;
    return a < 0 ? missing_ : arc(a).cost;
  };
  // The unit of a supply is there at no cost, and it cannot stay unused.
  const bool is_supply = has_supply(here.first);
  const std::int64_t entry = is_supply ? 0 : cost_of_end(node(here.first).entry_arc);
  const std::int64_t exit = cost_of_end(node(here.last).exit_arc);
  problem_.alone.push_back(chooses_next_ ? exit : entry);
  problem_.unused.push_back(chooses_next_ ? entry : exit);
  const auto begin = static_cast<std::int32_t>(problem_.choices.size());
  const std::int32_t links = chooses_next_ ? node(here.last).out : node(here.first).in;
  problem_.row_begin.push_back(begin);
  problem_.choices.resize(index(begin + 1 + links));
  problem_.choices[index(begin)] = {-here.own_cost, number, -1};
  problem_.row_end.push_back(is_supply ? begin : begin + 1);
}

/// The last pass over the arcs.
void PathReduction::add_links() {
  for (std::size_t a = 0; a < graph_.arcs.size(); ++a) {
    const FlowArc& here = graph_.arcs[a];
    if (!is_link(here)) continue;
    const int from = detection_of(here.tail);
    const int to = detection_of(here.head);
    const int agent = chooses_next_ ? from : to;
    const int object = chooses_next_ ? to : from;
    if (here.cost >= problem_.alone[index(agent)] + problem_.unused[index(object)]) continue;
    problem_.choices[index(problem_.row_end[index(agent)]++)] = {here.cost, object,
                                                                 static_cast<std::int32_t>(a)};
  }
}

std::int64_t PathReduction::small_step() const {
  double sum = 0.0;
  std::int64_t ends = 0;
  const auto add = [&](std::int64_t cost) {
    if (cost == missing_) return;
    sum += std::abs(static_cast<double>(cost));
    ++ends;
  };
  for (const std::int64_t cost : problem_.alone) add(cost);
  for (const std::int64_t cost : problem_.unused) add(cost);
  if (ends == 0) return 1;
  return std::max<std::int64_t>(1, std::llround(sum / static_cast<double>(ends) / 100.0));
}

void PathReduction::carry(int detection, std::vector<std::int64_t>& flow) const {
  const Detection& used = detections_[index(detection)];
  for (int n = used.first; n != used.last;) {
    const auto next = index(node(n).out_arc);
    flow[next] = 1;
    n = graph_.arcs[next].head;
  }
}

/// False if some path has no arc to start or to end with.
bool PathReduction::route(const OneSidedMatcher& matcher, std::vector<std::int64_t>& flow) const {
  for (int d = 0; d < problem_.agents(); ++d) {
    if (matcher.owner(d) == d) continue;
    const Detection& used = detections_[index(d)];
    carry(d, flow);
    const std::int32_t pick = matcher.pick(d);
    const bool is_alone = pick == OneSidedMatcher::kAlone;
    const bool is_free = matcher.owner(d) < 0;
    if (!is_alone) flow[index(problem_.choices[index(pick)].arc)] = 1;
    if ((chooses_next_ ? is_free : is_alone) && !has_supply(used.first)) {
      if (node(used.first).entry_arc < 0) return false;
      flow[index(node(used.first).entry_arc)] = 1;
    }
    if (chooses_next_ ? is_alone : is_free) {
      if (node(used.last).exit_arc < 0) return false;
      flow[index(node(used.last).exit_arc)] = 1;
    }
  }
  for (std::size_t a = 0; a < flow.size(); ++a) {
    const FlowArc& here = graph_.arcs[a];
    if (here.tail == graph_.source && here.head == sink_ && here.cost < 0) flow[a] = here.capacity;
  }
  return true;
}

/// Only one arc of a detection, of capacity 1, gets a negative reduced cost: its first own one, or
/// where it is a single node, the only arc into or out of it.
void PathReduction::set_potentials(int detection, std::int64_t at_entry, std::int64_t at_exit,
                                   std::vector<std::int64_t>& potential) const {
  const Detection& here = detections_[index(detection)];
  std::int64_t y = at_exit;
  int n = here.last;
  potential[index(n)] = y;
  while (n != here.first) {
    const FlowArc& own = arc(node(n).in_arc);
    y -= own.cost;
    n = own.tail;
    potential[index(n)] = y;
  }
  if (has_supply(here.first)) return;
  if (here.first != here.last || node(here.first).in > 1) potential[index(here.first)] = at_entry;
}

FlowResult PathReduction::result(const OneSidedMatcher& matcher) const {
  FlowResult result;
  std::vector<std::int64_t> flow(graph_.arcs.size());
  if (!route(matcher, flow)) return result;
  result.outcome = FlowOutcome::kOptimal;
  result.flow = std::move(flow);
  result.potential.resize(nodes_.size());
  for (int d = 0; d < problem_.agents(); ++d) {
    const std::int64_t in = chooses_next_ ? matcher.price(d) : matcher.value(d);
    const std::int64_t out = chooses_next_ ? matcher.value(d) : matcher.price(d);
    set_potentials(d, in, -out, result.potential);
  }
  return result;
}

}  // namespace mda
