#include "algorithms/testing/tracking_graphs.h"

#include <algorithm>
#include <cmath>

#include "algorithms/testing/draw.h"

namespace mda::testing {
namespace {

struct Point {
  double x;
  double y;
};

/// Where things are, scan by scan.
class World {
 public:
  World(const TrackingShape& shape, std::uint64_t seed) : shape_(shape), draw_(seed) {
    for (int t = 0; t < shape.targets; ++t) targets_.push_back(born());
  }

  std::vector<Point> next_scan() {
    std::vector<Point> points;
    for (Target& target : targets_) {
      if (draw_.chance(1.0 / shape_.mean_life)) target = born();
      target.at.x += target.velocity.x + spread(1.0);
      target.at.y += target.velocity.y + spread(1.0);
      if (!draw_.chance(shape_.detection)) continue;
      points.push_back({target.at.x + spread(2.0), target.at.y + spread(2.0)});
    }
    for (int c = 0; c < shape_.clutter; ++c) points.push_back(anywhere());
    return points;
  }

 private:
  struct Target {
    Point at;
    Point velocity;
  };

  double spread(double width) { return width * (2.0 * draw_.unit() - 1.0); }
  Point anywhere() { return {shape_.side * draw_.unit(), shape_.side * draw_.unit()}; }
  Target born() { return {anywhere(), {spread(shape_.speed), spread(shape_.speed)}}; }

  const TrackingShape& shape_;
  Draw draw_;
  std::vector<Target> targets_;
};

class Links {
 public:
  Links(const TrackingShape& shape, std::uint64_t seed) : shape_(shape), draw_(seed) {}

  std::int64_t units(double cost) const {
    constexpr double kUnitsPerNat = 1 << 20;
    return std::llround(shape_.whole_numbers ? cost : cost * kUnitsPerNat);
  }

  GrowingDetection detection() {
    const double cost = shape_.point_cost + 2.0 * draw_.unit() - 1.0;
    return {units(cost), end(), end(), {}};
  }

  std::optional<std::int64_t> end() {
    if (shape_.terminals < 1.0 && !draw_.chance(shape_.terminals)) return std::nullopt;
    return units(shape_.end_cost);
  }

  /// The links to a point from those of a scan that is `gap` scans older.
  void add(const Point& to, const std::vector<Point>& scan, int first, int gap,
           std::vector<GrowingLink>& links) {
    const double longest = shape_.gate * gap;
    const double share = shape_.links / static_cast<double>(scan.size());
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const double skipped = 2.0 * (gap - 1);
      const int from = first + static_cast<int>(i);
      if (shape_.targets == 0) {
        if (shape_.links > 0.0 && !draw_.chance(share)) continue;
        links.push_back({from, units(skipped + shape_.worst_link * draw_.unit())});
        continue;
      }
      const double dx = to.x - scan[i].x;
      const double dy = to.y - scan[i].y;
      const double squared = dx * dx + dy * dy;
      if (shape_.gate > 0.0 && squared > longest * longest) continue;
      const double width = shape_.speed * gap;
      links.push_back({from, units(skipped + 0.5 * squared / (width * width))});
    }
  }

 private:
  const TrackingShape& shape_;
  Draw draw_;
};

/// The graph of a window while it is made: nodes of a layer link to those of the next one.
class Window {
 public:
  explicit Window(int tracks) : tracks_(tracks) {
    graph_.nodes = 1;
    graph_.supply = {-tracks};
  }

  int add_node(std::int64_t supply) {
    graph_.supply.push_back(supply);
    return graph_.nodes++;
  }
  void add_arc(int tail, int head, double cost) {
    constexpr double kUnitsPerNat = 1 << 20;
    graph_.arcs.push_back({tail, head, 1, std::llround(cost * kUnitsPerNat)});
  }
  [[nodiscard]] FlowGraph finish(const std::vector<int>& tails) {
    for (const int tail : tails) add_arc(tail, 0, 0.0);
    return graph_;
  }
  [[nodiscard]] int tracks() const { return tracks_; }

 private:
  FlowGraph graph_;
  int tracks_;
};

}  // namespace

std::vector<std::vector<GrowingDetection>> tracking_scans(const TrackingShape& shape,
                                                          std::uint64_t seed) {
  World world(shape, seed);
  Links links(shape, seed + 1);
  std::vector<std::vector<Point>> points;
  std::vector<int> first;
  std::vector<std::vector<GrowingDetection>> scans;
  int next = 0;
  for (int s = 0; s < shape.scans; ++s) {
    points.push_back(world.next_scan());
    first.push_back(next);
    next += static_cast<int>(points.back().size());
    std::vector<GrowingDetection>& scan = scans.emplace_back();
    for (const Point& point : points.back()) {
      scan.push_back(links.detection());
      for (int gap = 1; gap <= std::min(shape.reach, s); ++gap) {
        const auto before = static_cast<std::size_t>(s - gap);
        links.add(point, points[before], first[before], gap, scan.back().links);
      }
    }
  }
  return scans;
}

FlowGraph graph_of_scans(const std::vector<std::vector<GrowingDetection>>& all, std::size_t scans) {
  FlowGraph graph;
  graph.source = 0;
  graph.sink = 1;
  graph.nodes = 2;
  for (std::size_t s = 0; s < scans; ++s) {
    for (const GrowingDetection& detection : all[s]) {
      const int in = graph.nodes;
      graph.nodes += 2;
      if (detection.entry) graph.arcs.push_back({0, in, 1, *detection.entry});
      graph.arcs.push_back({in, in + 1, 1, detection.cost});
      if (detection.exit) graph.arcs.push_back({in + 1, 1, 1, *detection.exit});
      for (const GrowingLink& link : detection.links) {
        graph.arcs.push_back({3 + 2 * link.from, in, 1, link.cost});
      }
    }
  }
  graph.supply.assign(static_cast<std::size_t>(graph.nodes), 0);
  return graph;
}

FlowGraph tracking_graph(const TrackingShape& shape, std::uint64_t seed) {
  const auto scans = tracking_scans(shape, seed);
  return graph_of_scans(scans, scans.size());
}

FlowGraph window_graph(int scans, int tracks, bool is_gated, std::uint64_t seed) {
  constexpr double kGate = 12.0;
  constexpr double kMissed = 3.0;
  Draw draw(seed);
  const double side = 10.0 * std::sqrt(tracks);
  Window window(tracks);
  std::vector<int> tails;
  std::vector<Point> at;
  std::vector<Point> slot;
  for (int t = 0; t < tracks; ++t) {
    tails.push_back(window.add_node(1));
    slot.push_back({side * draw.unit(), side * draw.unit()});
  }
  at = slot;
  for (int s = 0; s < scans; ++s) {
    std::vector<int> new_tails;
    std::vector<Point> new_at;
    for (int i = 0; i < 2 * tracks; ++i) {
      const bool is_missed = i >= tracks;
      Point here = slot[static_cast<std::size_t>(i % tracks)];
      if (!is_missed) here = {here.x + 6.0 * draw.unit() - 3.0, here.y + 6.0 * draw.unit() - 3.0};
      const int in = window.add_node(0);
      const int out = window.add_node(0);
      window.add_arc(in, out, is_missed ? kMissed : draw.unit());
      for (std::size_t j = 0; j < tails.size(); ++j) {
        const double squared =
            (here.x - at[j].x) * (here.x - at[j].x) + (here.y - at[j].y) * (here.y - at[j].y);
        if (is_gated && squared > kGate * kGate) continue;
        window.add_arc(tails[j], in, squared / 18.0);
      }
      new_tails.push_back(out);
      new_at.push_back(here);
    }
    tails = new_tails;
    at = new_at;
  }
  return window.finish(tails);
}

}  // namespace mda::testing
