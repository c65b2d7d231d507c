#include "algorithms/marginal/jpda_cheap.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/marginal/scan_marginals.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

class JpdaCheap final : public ClusterMethod {
 public:
  /// A pair's terms are all divided by the largest weight of its row and its column, so that any
  /// weight will do.
  [[nodiscard]] ClusterAnswer solve(const Cluster& cluster, const Budget& /*budget*/,
                                    std::span<double> pair_probability) override {
    sum_up(cluster);
    for (int t = 0; t < cluster.tracks(); ++t) {
      const Sum& track = track_sum_[index(t)];
      const auto end = index(cluster.track_begin[index(t) + 1]);
      for (auto p = index(cluster.track_begin[index(t)]); p < end; ++p) {
        const Sum& plot = plot_sum_[index(cluster.plot[p])];
        const double unit = std::max(track.largest, plot.largest);
        const double weight = std::exp(cluster.log_weight[p] - unit);
        const double others = std::max(0.0, plot.in(unit)-weight);
        pair_probability[p] = weight / (std::exp(-unit) + track.in(unit) + others);
      }
    }
    return {};
  }

 private:
  /// A sum of weights in units of exp(largest), which is at least 1 and the largest of them.
  struct Sum {
    double largest = 0.0;
    double value = 0.0;

    [[nodiscard]] double in(double unit) const { return value * std::exp(largest - unit); }
  };

  void sum_up(const Cluster& cluster) {
    track_sum_.assign(index(cluster.tracks()), {});
    plot_sum_.assign(index(cluster.plots), {});
    for_each(cluster,
             [](Sum& sum, double log_weight) { sum.largest = std::max(sum.largest, log_weight); });
    for_each(cluster,
             [](Sum& sum, double log_weight) { sum.value += std::exp(log_weight - sum.largest); });
  }

  template <typename Add>
  void for_each(const Cluster& cluster, const Add& add) {
    for (int t = 0; t < cluster.tracks(); ++t) {
      const auto end = index(cluster.track_begin[index(t) + 1]);
      for (auto p = index(cluster.track_begin[index(t)]); p < end; ++p) {
        add(track_sum_[index(t)], cluster.log_weight[p]);
        add(plot_sum_[index(cluster.plot[p])], cluster.log_weight[p]);
      }
    }
  }

  std::vector<Sum> track_sum_;
  std::vector<Sum> plot_sum_;
};

}  // namespace

std::unique_ptr<Associator> make_jpda_cheap() {
  return make_scan_marginals(std::make_unique<JpdaCheap>(), {.consistent = true});
}

}  // namespace mda
