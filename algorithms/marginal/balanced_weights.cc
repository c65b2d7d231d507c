#include "algorithms/marginal/balanced_weights.h"

#include <algorithm>
#include <cmath>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Of a reduced cost, which only rounding makes negative.
double weight_of(double reduced_cost) { return std::exp(-std::max(0.0, reduced_cost)); }

}  // namespace

const BalancedWeights& Balancer::balance(const Cluster& cluster) {
  costs_.columns = cluster.plots;
  costs_.row_begin = cluster.track_begin;
  costs_.column = cluster.plot;
  costs_.cost.clear();
  for (const double log_weight : cluster.log_weight) costs_.cost.push_back(-log_weight);
  costs_.alone.assign(index(cluster.tracks()), 0.0);
  const Assignment& best = solver_.solve(costs_);
  weights_.pair.clear();
  weights_.free_track.clear();
  weights_.free_plot.clear();
  for (const double price : best.column_price) weights_.free_plot.push_back(weight_of(price));
  for (int t = 0; t < cluster.tracks(); ++t) {
    const double price = best.row_price[index(t)];
    weights_.free_track.push_back(weight_of(-price));
    for (int p = cluster.track_begin[index(t)]; p < cluster.track_begin[index(t) + 1]; ++p) {
      const double plot_price = best.column_price[index(cluster.plot[index(p)])];
      weights_.pair.push_back(weight_of(costs_.cost[index(p)] + plot_price - price));
    }
  }
  return weights_;
}

}  // namespace mda
