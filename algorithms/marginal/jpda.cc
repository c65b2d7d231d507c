#include "algorithms/marginal/jpda.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/marginal/balanced_weights.h"
#include "algorithms/marginal/frontier_sum.h"
#include "algorithms/marginal/scan_marginals.h"

namespace mda {
namespace {

/// A way to run the dynamic programme.
struct Way {
  bool mask_tracks = true;
  Incidence incidence;
  FrontierOrder order;
};

Way find_way(const Cluster& cluster, bool mask_tracks) {
  Way way{.mask_tracks = mask_tracks, .incidence = incidence_of(cluster, mask_tracks), .order = {}};
  way.order = find_frontier_order(way.incidence);
  return way;
}

class Jpda final : public ClusterMethod {
 public:
  explicit Jpda(const JpdaOptions& options)
      : options_(options),
        sum_(options.portable_kernel ? portable_frontier_kernel() : fastest_frontier_kernel()) {
    options_.most_masked = std::min(options_.most_masked, kMostFrontierBits);
  }

  [[nodiscard]] ClusterAnswer solve(const Cluster& cluster, const Budget& budget,
                                    std::span<double> pair_probability) override {
    if (budget.expired()) return {.known = false, .stop = Stop::kDeadline};
    const Way way = best_way(cluster);
    if (!affordable(way)) return {.known = false, .note = refusal(cluster, way.order)};
    const BalancedWeights& weights = balancer_.balance(cluster);
    const auto& layers = way.mask_tracks ? weights.free_plot : weights.free_track;
    const auto& bits = way.mask_tracks ? weights.free_track : weights.free_plot;
    const auto steps = plan_frontier(
        way.incidence, way.order, {.pair = weights.pair, .free_layer = layers, .free_bit = bits});
    if (sum_.solve(steps, budget, pair_probability)) return {};
    return {.known = false, .stop = Stop::kDeadline};
  }

 private:
  [[nodiscard]] Way best_way(const Cluster& cluster) const {
    if (options_.masked != Masked::kCheaper) {
      return find_way(cluster, options_.masked == Masked::kTracks);
    }
    Way tracks = find_way(cluster, true);
    Way plots = find_way(cluster, false);
    return plots.order.work < tracks.order.work ? std::move(plots) : std::move(tracks);
  }

  [[nodiscard]] bool affordable(const Way& way) const {
    return way.order.width <= options_.most_masked &&
           FrontierSum::bytes(way.incidence.layers(), way.order.width) <= options_.most_bytes;
  }

  [[nodiscard]] static std::string refusal(const Cluster& cluster, const FrontierOrder& order) {
    return "a cluster of " + std::to_string(cluster.tracks()) + " tracks and " +
           std::to_string(cluster.plots) + " plots needs a frontier of " +
           std::to_string(order.width) + " rows, more than it may take; lbp approximates any width";
  }

  JpdaOptions options_;
  Balancer balancer_;
  FrontierSum sum_;
};

}  // namespace

std::unique_ptr<Associator> make_jpda(const JpdaOptions& options) {
  return make_scan_marginals(std::make_unique<Jpda>(options), {.consistent = true});
}

}  // namespace mda
