#include "harness/known_metrics.h"

#include <cmath>
#include <numeric>

namespace mda {
namespace {

double distance_km(const TargetState& a, const TargetState& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

double mean(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double mean_distance_km(const std::vector<TargetState>& a, const std::vector<TargetState>& b) {
  std::vector<double> distances;
  for (std::size_t n = 0; n < a.size(); ++n) distances.push_back(distance_km(a[n], b[n]));
  return mean(distances);
}

std::vector<double> mean_distances_km(const TrackStates& a, const TrackStates& b) {
  std::vector<double> distances;
  for (std::size_t t = 0; t < a.size(); ++t) distances.push_back(mean_distance_km(a[t], b[t]));
  return distances;
}

LostShares lost_shares(const TrackStates& states, const TrackStates& reference, double lost_km) {
  const std::size_t tracks = states.front().size();
  LostShares shares;
  for (std::size_t n = 0; n < tracks; ++n) {
    bool ever = false;
    bool now = false;
    for (std::size_t t = 0; t < states.size(); ++t) {
      now = distance_km(states[t][n], reference[t][n]) > lost_km;
      ever = ever || now;
    }
    shares.ever += ever ? 1.0 / static_cast<double>(tracks) : 0.0;
    shares.at_end += now ? 1.0 / static_cast<double>(tracks) : 0.0;
  }
  return shares;
}

}  // namespace mda
