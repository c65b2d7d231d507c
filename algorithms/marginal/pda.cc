#include "algorithms/marginal/pda.h"

#include <algorithm>
#include <cmath>

#include "algorithms/marginal/scan_marginals.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

class Pda final : public ClusterMethod {
 public:
  [[nodiscard]] ClusterAnswer solve(const Cluster& cluster, const Budget& /*budget*/,
                                    std::span<double> pair_probability) override {
    for (int t = 0; t < cluster.tracks(); ++t) {
      const auto begin = index(cluster.track_begin[index(t)]);
      const auto end = index(cluster.track_begin[index(t) + 1]);
      double largest = 0.0;
      for (auto p = begin; p < end; ++p) largest = std::max(largest, cluster.log_weight[p]);
      double sum = std::exp(-largest);
      for (auto p = begin; p < end; ++p) {
        pair_probability[p] = std::exp(cluster.log_weight[p] - largest);
        sum += pair_probability[p];
      }
      for (auto p = begin; p < end; ++p) pair_probability[p] /= sum;
    }
    return {};
  }
};

}  // namespace

std::unique_ptr<Associator> make_pda() {
  return make_scan_marginals(std::make_unique<Pda>(), {.consistent = false});
}

}  // namespace mda
