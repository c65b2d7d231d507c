#include "harness/position_metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace mda {
namespace {

double distance_km(const TargetState& a, const TargetState& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

double speed_km_s(const TargetState& a, const TargetState& b) {
  return std::hypot(a.vx - b.vx, a.vy - b.vy);
}

template <typename Distance>
std::vector<double> distances(const StateSeries& a, const StateSeries& b, Distance distance) {
  std::vector<double> result;
  std::ranges::transform(a, b, std::back_inserter(result), distance);
  return result;
}

/// Distances in the last kLastScans scans, or in all if there are fewer.
std::vector<double> last_distances_km(const StateSeries& a, const StateSeries& b) {
  std::vector<double> all = distances(a, b, distance_km);
  all.erase(all.begin(), all.end() - std::min<std::ptrdiff_t>(kLastScans, std::ssize(all)));
  return all;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::ranges::max_element(values);
}

double smallest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::ranges::min_element(values);
}

/// Whether track i follows target j instead of its own.
bool has_moved_to(const TrackSet& set, std::size_t i, std::size_t j) {
  const std::vector<double> own = last_distances_km(set.tracks[i], set.targets[i]);
  const std::vector<double> other = last_distances_km(set.tracks[i], set.targets[j]);
  return std::accumulate(other.begin(), other.end(), 0.0) <
             std::accumulate(own.begin(), own.end(), 0.0) &&
         largest(other) < kStrictLossKm;
}

int count_pairs(const TrackSet& set, const std::function<bool(std::size_t, std::size_t)>& counts) {
  int pairs = 0;
  for (std::size_t i = 0; i < set.tracks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!set.dropped[i] && !set.dropped[j] && counts(i, j)) ++pairs;
    }
  }
  return pairs;
}

}  // namespace

TrackErrors track_errors(const StateSeries& filtered, const StateSeries& predicted,
                         const StateSeries& truth) {
  return {.position_km = distances(filtered, truth, distance_km),
          .velocity_km_s = distances(filtered, truth, speed_km_s),
          .predicted_position_km = distances(predicted, truth, distance_km),
          .predicted_velocity_km_s = distances(predicted, truth, speed_km_s)};
}

double sum_of_squares(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

bool is_maintained(const std::vector<double>& position_km, double loss_km) {
  const auto last = std::min<std::ptrdiff_t>(kLastScans, std::ssize(position_km));
  return std::all_of(position_km.end() - last, position_km.end(),
                     [&](double error) { return error < loss_km; });
}

int swaps(const TrackSet& set) {
  return count_pairs(set, [&](std::size_t i, std::size_t j) {
    return has_moved_to(set, i, j) && has_moved_to(set, j, i);
  });
}

int coalescences(const TrackSet& set, double sigma_km) {
  return count_pairs(set, [&](std::size_t i, std::size_t j) {
    return largest(last_distances_km(set.tracks[i], set.tracks[j])) <= sigma_km &&
           smallest(last_distances_km(set.targets[i], set.targets[j])) > sigma_km;
  });
}

}  // namespace mda
