#include "algorithms/testing/random_pair_scans.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "algorithms/testing/draw.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

struct Point {
  double x = 0.0;  ///< km
  double y = 0.0;
};

struct Track {
  Point predicted;
  Point step;              ///< km per scan, never zero
  double x_variance = 0.;  ///< km^2, of the innovation
  double y_variance = 0.;
  double cost_before = 0.;  ///< nats
};

double normal(Draw& draw) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - draw.unit()));
  return radius * std::cos(2.0 * std::numbers::pi * draw.unit());
}

std::vector<Track> random_tracks(const PairScanShape& shape, Draw& draw) {
  std::vector<Track> tracks(index(shape.tracks));
  for (Track& track : tracks) {
    track.predicted = {shape.side_km * draw.unit(), shape.side_km * draw.unit()};
    const double heading = 2.0 * std::numbers::pi * draw.unit();
    track.step = {0.3 * std::cos(heading), 0.3 * std::sin(heading)};
    track.x_variance = 0.02 + 0.05 * draw.unit();
    track.y_variance = 0.02 + 0.05 * draw.unit();
    track.cost_before = -5.0 - 10.0 * draw.unit();
  }
  return tracks;
}

std::vector<Point> random_plots(const PairScanShape& shape, const std::vector<Track>& tracks,
                                Draw& draw) {
  constexpr double kAroundATrack = 2.0 / 3.0;
  std::vector<Point> plots(index(shape.plots));
  for (Point& plot : plots) {
    if (tracks.empty() || !draw.chance(kAroundATrack)) {
      plot = {shape.side_km * draw.unit(), shape.side_km * draw.unit()};
      continue;
    }
    const Track& track = tracks[index(draw.below(shape.tracks))];
    plot = {track.predicted.x + std::sqrt(track.x_variance) * normal(draw),
            track.predicted.y + std::sqrt(track.y_variance) * normal(draw)};
  }
  return plots;
}

template <typename T>
std::vector<T> reordered(const std::vector<T>& plain, const std::vector<int>& order) {
  std::vector<T> result;
  for (const int i : order) result.push_back(plain[index(i)]);
  return result;
}

std::vector<int> plain_or_shuffled(int n, std::uint64_t order, std::uint64_t purpose) {
  if (order != 0) return Draw(order * 977 + purpose).permutation(n);
  std::vector<int> plain(index(n));
  std::iota(plain.begin(), plain.end(), 0);
  return plain;
}

/// What a pair looks like to the filter.
void add_pair(const Track& track, const Point& plot, PairView& view) {
  const Point from = {plot.x - track.predicted.x, plot.y - track.predicted.y};
  const double distance = from.x * from.x / track.x_variance + from.y * from.y / track.y_variance;
  const double across = from.x * track.step.y - from.y * track.step.x;
  const double length2 = track.step.x * track.step.x + track.step.y * track.step.y;
  view.distance.push_back(distance);
  view.line_distance.push_back(across * across / length2);
  view.log_likelihood.push_back(
      -0.5 * distance -
      std::log(2.0 * std::numbers::pi * std::sqrt(track.x_variance * track.y_variance)));
}

/// Tracks and plots of the view in the order given; rows and columns in one of their own.
class ScanMaker {
 public:
  ScanMaker(const PairScanShape& shape, std::vector<Track> tracks, const std::vector<Point>& plots)
      : shape_(shape), tracks_(std::move(tracks)) {
    for (const Track& track : tracks_) {
      for (const Point& plot : plots) add_pair(track, plot, view_);
    }
    view_.plot_row.resize(plots.size());
    view_.gate = shape.gate;
    view_.detection_probability = shape.detection_probability;
    view_.gate_probability = 1.0 - std::exp(-0.5 * std::max(0.0, shape.gate));
    view_.clutter_density = 0.8;
  }

  AssociationProblem make(std::uint64_t order) {
    add_rows(order);
    add_columns(order);
    AssociationProblem problem = builder_.build();
    auto views = std::make_shared<Views>();
    views->pairs = view_;
    problem.attach(std::move(views));
    return problem;
  }

 private:
  void add_rows(std::uint64_t order) {
    const int n = shape_.tracks;
    view_.track_row.resize(index(n));
    for (const int i : plain_or_shuffled(n + shape_.plots, order, 3)) {
      if (i < n) {
        view_.track_row[index(i)] =
            builder_.add_row(0, shape_.must_go_on ? RowUse::kExactlyOnce : RowUse::kAtMostOnce);
      } else {
        view_.plot_row[index(i - n)] = builder_.add_row(1, RowUse::kAtMostOnce);
      }
    }
    builder_.set_dimensions(2);
  }

  /// Candidate t * (m + 1) + j is the pair of track t and plot j, or, with j = m, no detection.
  void add_columns(std::uint64_t order) {
    const int m = shape_.plots;
    view_.column.assign(view_.distance.size(), kNoColumn);
    view_.miss_column.assign(tracks_.size(), kNoColumn);
    for (const int i : plain_or_shuffled(shape_.tracks * (m + 1), order, 4)) {
      const int t = i / (m + 1);
      const int j = i % (m + 1);
      const double before = tracks_[index(t)].cost_before;
      if (j == m) {
        const double missed = 1.0 - view_.detection_probability * view_.gate_probability;
        view_.miss_column[index(t)] =
            builder_.add_column(before - std::log(missed), std::vector{view_.track_row[index(t)]});
      } else if (view_.distance[view_.at(t, j)] <= view_.gate) {
        const double ratio = view_.log_likelihood[view_.at(t, j)] +
                             std::log(view_.detection_probability / view_.clutter_density);
        view_.column[view_.at(t, j)] = builder_.add_column(
            before - ratio, std::vector{view_.track_row[index(t)], view_.plot_row[index(j)]});
      }
    }
  }

  PairScanShape shape_;
  std::vector<Track> tracks_;
  PairView view_;
  ProblemBuilder builder_;
};

}  // namespace

PairScanShape random_pair_scan_shape(std::uint64_t seed) {
  Draw draw(seed);
  PairScanShape shape;
  shape.tracks = draw.below(6);
  shape.plots = draw.below(9);
  shape.side_km = 0.3 + 2.0 * draw.unit();
  shape.detection_probability = 0.5 + 0.45 * draw.unit();
  shape.must_go_on = draw.chance(0.5);
  return shape;
}

AssociationProblem random_pair_scan(const PairScanShape& shape, std::uint64_t seed,
                                    std::uint64_t order) {
  Draw draw(seed);
  const std::vector<Track> tracks = random_tracks(shape, draw);
  const std::vector<Point> plots = random_plots(shape, tracks, draw);
  return ScanMaker(shape, reordered(tracks, plain_or_shuffled(shape.tracks, order, 1)),
                   reordered(plots, plain_or_shuffled(shape.plots, order, 2)))
      .make(order);
}

}  // namespace mda::testing
