#include "algorithms/marginal/lbp.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/marginal/balanced_weights.h"
#include "algorithms/marginal/scan_marginals.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Keeps the messages finite; a free row of less weight is as good as impossible.
constexpr double kLeastFree = 1e-300;

/// With w the weight of pair (t, j), u and v those of t and j being free, the messages are
///     mu(t -> j) = w_tj / (u_t + sum over the other plots k of t of w_tk nu(k -> t))
///     nu(j -> t) = 1 / (v_j + sum over the other tracks s of j of mu(s -> j)),
/// and the belief in the pair is w nu / (u_t + sum over all plots of t of w nu).
class Lbp final : public ClusterMethod {
 public:
  explicit Lbp(const LbpOptions& options) : options_(options) {}

  [[nodiscard]] ClusterAnswer solve(const Cluster& cluster, const Budget& budget,
                                    std::span<double> pair_probability) override {
    prepare(cluster);
    const double sureness = largest_sureness(cluster);
    ClusterAnswer answer{.stop = Stop::kIterationLimit, .iterations = 0};
    while (answer.iterations < options_.most_iterations) {
      constexpr std::int64_t kIterationsBetweenLooks = 32;
      if (*answer.iterations % kIterationsBetweenLooks == 0 && budget.expired()) {
        return {.known = false, .stop = Stop::kDeadline};
      }
      ++*answer.iterations;
      const double moved = update_to_plots(cluster);
      update_to_tracks(cluster);
      if (*answer.iterations > 1 && has_converged(moved, sureness)) {
        answer.stop = Stop::kFinished;
        break;
      }
    }
    write_beliefs(cluster, pair_probability);
    return answer;
  }

 private:
  void prepare(const Cluster& cluster) {
    weights_ = &balancer_.balance(cluster);
    pairs_of_plot_.assign(index(cluster.plots), {});
    for (int p = 0; p < cluster.pairs(); ++p) {
      pairs_of_plot_[index(cluster.plot[index(p)])].push_back(p);
    }
    to_plot_.assign(index(cluster.pairs()), 0.0);
    to_track_.resize(index(cluster.pairs()));
    update_to_tracks(cluster);
  }

  /// The largest odds of any track for being in a pair when it has no rival.
  [[nodiscard]] static double largest_sureness(const Cluster& cluster) {
    constexpr double kMostNats = 700.0;
    double largest = 0.0;
    for (int t = 0; t < cluster.tracks(); ++t) {
      double odds = 0.0;
      for (int p = cluster.track_begin[index(t)]; p < cluster.track_begin[index(t) + 1]; ++p) {
        odds += std::exp(std::min(kMostNats, cluster.log_weight[index(p)]));
      }
      largest = std::max(largest, odds);
    }
    return largest;
  }

  /// Two sets of messages to tracks that differ by a factor of d = exp(moved) at most make messages
  /// to plots that differ by (1 + d s) / (1 + s) at most, s the largest sureness; the messages back
  /// differ no more than these. So log d shrinks by a factor of `rate` at least in every iteration,
  /// ever faster, and all that is to come moves a message by rate / (1 - rate) moved at most. A
  /// belief may move by twice that. Below rounding nothing moves any more.
  [[nodiscard]] bool has_converged(double moved, double sureness) const {
    constexpr double kRounding = 1e-14;
    if (moved <= kRounding) return true;
    const double rate = std::log1p(std::expm1(moved) * sureness / (1.0 + sureness)) / moved;
    return 2.0 * moved * rate <= std::log1p(options_.tolerance) * (1.0 - rate);
  }

  /// Calls set(i, sum of terms but that of i) for every i in 0..count-1, without a subtraction.
  template <typename Term, typename Set>
  void for_each_rest(double free, std::size_t count, const Term& term, const Set& set) {
    after_.assign(count + 1, 0.0);
    for (std::size_t i = count; i-- > 0;) after_[i] = after_[i + 1] + term(i);
    double before = std::max(free, kLeastFree);
    for (std::size_t i = 0; i < count; ++i) {
      set(i, before + after_[i + 1]);
      before += term(i);
    }
  }

  /// Returns the largest change of a message's logarithm.
  double update_to_plots(const Cluster& cluster) {
    double highest = 1.0;
    double lowest = 1.0;
    for (int t = 0; t < cluster.tracks(); ++t) {
      const auto begin = index(cluster.track_begin[index(t)]);
      const auto count = index(cluster.track_begin[index(t) + 1]) - begin;
      const double* weight = weights_->pair.data() + begin;
      const double* back = to_track_.data() + begin;
      for_each_rest(
          weights_->free_track[index(t)], count, [&](std::size_t i) { return weight[i] * back[i]; },
          [&](std::size_t i, double rest) {
            const double message = weight[i] / rest;
            const double before = std::exchange(to_plot_[begin + i], message);
            if (message == 0.0) return;
            highest = std::max(highest, message / before);
            lowest = std::min(lowest, message / before);
          });
    }
    return std::max(std::log(highest), -std::log(lowest));
  }

  void update_to_tracks(const Cluster& cluster) {
    for (int j = 0; j < cluster.plots; ++j) {
      const std::vector<int>& pairs = pairs_of_plot_[index(j)];
      for_each_rest(
          weights_->free_plot[index(j)], pairs.size(),
          [&](std::size_t i) { return to_plot_[index(pairs[i])]; },
          [&](std::size_t i, double rest) { to_track_[index(pairs[i])] = 1.0 / rest; });
    }
  }

  void write_beliefs(const Cluster& cluster, std::span<double> belief) const {
    for (int t = 0; t < cluster.tracks(); ++t) {
      const auto begin = index(cluster.track_begin[index(t)]);
      const auto end = index(cluster.track_begin[index(t) + 1]);
      double sum = std::max(weights_->free_track[index(t)], kLeastFree);
      for (auto p = begin; p < end; ++p) {
        belief[p] = weights_->pair[p] * to_track_[p];
        sum += belief[p];
      }
      for (auto p = begin; p < end; ++p) belief[p] /= sum;
    }
  }

  LbpOptions options_;
  Balancer balancer_;
  const BalancedWeights* weights_ = nullptr;
  std::vector<std::vector<int>> pairs_of_plot_;
  std::vector<double> to_plot_;   ///< mu, per pair
  std::vector<double> to_track_;  ///< nu, per pair
  std::vector<double> after_;
};

}  // namespace

std::unique_ptr<Associator> make_lbp(const LbpOptions& options) {
  return make_scan_marginals(std::make_unique<Lbp>(options), {.consistent = false});
}

}  // namespace mda
