#include "algorithms/testing/random_scans.h"

#include <cmath>
#include <vector>

#include "algorithms/testing/draw.h"

namespace mda::testing {

AssociationProblem random_scan(const ScanShape& shape, std::uint64_t seed) {
  struct Point {
    double x;
    double y;
    int row;
  };
  Draw draw(seed);
  ProblemBuilder builder;
  builder.set_dimensions(2);
  const auto scatter = [&](int count, int dimension) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
      const int row = builder.add_row(dimension, RowUse::kAtMostOnce);
      points.push_back({shape.length * draw.unit(), shape.height * draw.unit(), row});
    }
    return points;
  };
  const std::vector<Point> tracks = scatter(shape.tracks, 0);
  const std::vector<Point> plots = scatter(shape.plots, 1);
  for (const Point& track : tracks) {
    for (const Point& plot : plots) {
      if (std::abs(track.x - plot.x) > shape.gate || std::abs(track.y - plot.y) > shape.gate) {
        continue;
      }
      const double cost = shape.spread_nats * (2.0 * draw.unit() - 1.0);
      builder.add_column(cost, std::vector{track.row, plot.row});
    }
  }
  return builder.build();
}

}  // namespace mda::testing
