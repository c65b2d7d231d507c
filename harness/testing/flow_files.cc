#include "harness/testing/flow_files.h"

#include <fmt/format.h>

#include "algorithms/testing/draw.h"

namespace mda::testing {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

FlowLines random_tracking_lines(std::uint64_t seed) {
  Draw draw(seed);
  FlowLines lines;
  lines.nodes = 2 + draw.below(11);
  lines.supplies = {{0, draw.below(3)}, {lines.nodes - 1, draw.below(3)}};
  for (int arc = draw.below(4 * lines.nodes); arc >= 0; --arc) {
    const int tail = draw.below(lines.nodes - 1);
    const int head = tail + 1 + draw.below(lines.nodes - 1 - tail);
    const double cost = draw.chance(0.3) ? draw.below(3) - 1 : (draw.below(20481) - 10240) / 1024.0;
    lines.arcs.push_back({tail, head, fmt::format("{}", cost)});
  }
  return lines;
}

FlowLines random_dimacs_lines(std::uint64_t seed) {
  Draw draw(seed);
  FlowLines lines;
  lines.nodes = 2 + draw.below(9);
  std::int64_t supplied = 0;
  for (int node = 0; node + 1 < lines.nodes; ++node) {
    if (draw.chance(0.6)) continue;
    lines.supplies.push_back({node, draw.below(7) - 3});
    supplied += lines.supplies.back().supply;
  }
  lines.supplies.push_back({lines.nodes - 1, -supplied});
  for (int arc = 2 + draw.below(4 * lines.nodes); arc > 0; --arc) {
    const int tail = draw.below(lines.nodes);
    const int head = (tail + 1 + draw.below(lines.nodes - 1)) % lines.nodes;
    const int low = draw.chance(0.2) ? draw.below(3) : 0;
    lines.arcs.push_back(
        {tail, head, fmt::format("{} {} {}", low, low + draw.below(5), draw.below(41) - 20)});
  }
  return lines;
}

std::string text_of(const FlowLines& lines) {
  std::string text = fmt::format("p min {} {}\n", lines.nodes, lines.arcs.size());
  for (const auto& [number, supply] : lines.supplies) {
    text += fmt::format("n {} {}\n", number + 1, supply);
  }
  for (const auto& [tail, head, rest] : lines.arcs) {
    text += fmt::format("a {} {} {}\n", tail + 1, head + 1, rest);
  }
  return text;
}

FlowLines reordered(const FlowLines& lines, std::uint64_t seed) {
  Draw draw(seed);
  FlowLines other = lines;
  const std::vector<int> name = draw.permutation(lines.nodes);
  for (FlowLines::Node& node : other.supplies) node.number = name[index(node.number)];
  const std::vector<int> order = draw.permutation(static_cast<int>(lines.arcs.size()));
  for (std::size_t a = 0; a < order.size(); ++a) {
    other.arcs[a] = lines.arcs[index(order[a])];
    other.arcs[a].tail = name[index(other.arcs[a].tail)];
    other.arcs[a].head = name[index(other.arcs[a].head)];
  }
  return other;
}

}  // namespace mda::testing
