#include "algorithms/marginal/hnpda.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/marginal/scan_marginals.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr std::int64_t kIterationsPerLookAtTheClock = 64;

/// Neuron k < pairs belongs to pair k of the cluster, neuron pairs + t to track t without a plot.
class Network {
 public:
  Network(const Cluster& cluster, const HnpdaOptions& options)
      : cluster_(cluster),
        options_(options),
        self_(options.d + options.e * (cluster.tracks() - 1)),
        u_(index(cluster.pairs() + cluster.tracks()), 0.0),
        v_(u_.size(), 0.5),
        plot_sum_(index(cluster.plots)) {
    const double stiffness =
        self_ + options.a * cluster.tracks() + (options.b + options.c) * (cluster.plots + 1);
    dt_ = options.step * 2.0 * options.gain_width / stiffness;
    find_drive(own_probabilities());
  }

  ClusterAnswer run(const Budget& budget) {
    ClusterAnswer answer{.stop = Stop::kIterationLimit, .iterations = 0};
    while (*answer.iterations < options_.iterations) {
      if (*answer.iterations % kIterationsPerLookAtTheClock == 0 && budget.expired()) {
        answer.stop = Stop::kDeadline;
        break;
      }
      ++*answer.iterations;
      if (advance() <= options_.tolerance) {
        answer.stop = Stop::kFinished;
        break;
      }
    }
    return answer;
  }

  void read_outputs(std::span<double> probability) const {
    for (int t = 0; t < cluster_.tracks(); ++t) {
      double sum = 0.0;
      for (int k = first(t); k < last(t); ++k) sum += v_[index(k)];
      const double whole = options_.normalised ? sum + v_[free(t)] : std::max(1.0, sum);
      for (int k = first(t); k < last(t); ++k) {
        probability[index(k)] = whole > 0.0 ? v_[index(k)] / whole : 0.0;
      }
    }
  }

 private:
  [[nodiscard]] int first(int track) const { return cluster_.track_begin[index(track)]; }
  [[nodiscard]] int last(int track) const { return cluster_.track_begin[index(track) + 1]; }
  [[nodiscard]] std::size_t free(int track) const { return index(cluster_.pairs() + track); }

  /// rho per neuron.
  [[nodiscard]] std::vector<double> own_probabilities() const {
    std::vector<double> rho(u_.size());
    for (int t = 0; t < cluster_.tracks(); ++t) {
      double largest = 0.0;
      for (int k = first(t); k < last(t); ++k) {
        largest = std::max(largest, cluster_.log_weight[index(k)]);
      }
      double sum = rho[free(t)] = std::exp(-largest);
      for (int k = first(t); k < last(t); ++k) {
        sum += rho[index(k)] = std::exp(cluster_.log_weight[index(k)] - largest);
      }
      for (int k = first(t); k < last(t); ++k) rho[index(k)] /= sum;
      rho[free(t)] /= sum;
    }
    return rho;
  }

  /// C + D rho_tj + E sum_{s != t} (1 - rho_sj), where rho is 0 outside the gates.
  void find_drive(const std::vector<double>& rho) {
    std::vector<double> plot_rho(index(cluster_.plots), 0.0);
    double free_rho = 0.0;
    for (int k = 0; k < cluster_.pairs(); ++k) {
      plot_rho[index(cluster_.plot[index(k)])] += rho[index(k)];
    }
    for (int t = 0; t < cluster_.tracks(); ++t) free_rho += rho[free(t)];
    const auto drive = [&](double own, double of_all) {
      const double left = cluster_.tracks() - 1 - (of_all - own);
      return options_.c + options_.d * own + options_.e * left;
    };
    drive_.resize(u_.size());
    for (int k = 0; k < cluster_.pairs(); ++k) {
      drive_[index(k)] = drive(rho[index(k)], plot_rho[index(cluster_.plot[index(k)])]);
    }
    for (int t = 0; t < cluster_.tracks(); ++t) drive_[free(t)] = drive(rho[free(t)], free_rho);
  }

  /// Returns the largest change of an output.
  double advance() {
    std::fill(plot_sum_.begin(), plot_sum_.end(), 0.0);
    for (int k = 0; k < cluster_.pairs(); ++k) {
      plot_sum_[index(cluster_.plot[index(k)])] += v_[index(k)];
    }
    double change = 0.0;
    for (int t = 0; t < cluster_.tracks(); ++t) {
      double sum = v_[free(t)];
      for (int k = first(t); k < last(t); ++k) sum += v_[index(k)];
      for (int k = first(t); k < last(t); ++k) {
        const double others = plot_sum_[index(cluster_.plot[index(k)])] - v_[index(k)];
        change = std::max(change, move(index(k), others, sum));
      }
      change = std::max(change, move(free(t), 0.0, sum));
    }
    return change;
  }

  /// `others`: outputs of the other tracks for the neuron's plot; `sum`: of the track's neurons.
  double move(std::size_t neuron, double others, double sum) {
    const double v = v_[neuron];
    const double slope = drive_[neuron] - options_.decay * u_[neuron] - options_.a * others -
                         options_.b * (sum - v) - options_.c * sum - self_ * v;
    u_[neuron] += dt_ * slope;
    v_[neuron] = 0.5 * (1.0 + std::tanh(u_[neuron] / options_.gain_width));
    return std::abs(v_[neuron] - v);
  }

  const Cluster& cluster_;
  HnpdaOptions options_;
  double self_;  ///< D + E (n - 1)
  double dt_ = 0.0;
  std::vector<double> u_;
  std::vector<double> v_;
  std::vector<double> drive_;
  std::vector<double> plot_sum_;
};

class Hnpda final : public ClusterMethod {
 public:
  explicit Hnpda(const HnpdaOptions& options) : options_(options) {}

  [[nodiscard]] ClusterAnswer solve(const Cluster& cluster, const Budget& budget,
                                    std::span<double> pair_probability) override {
    Network network(cluster, options_);
    ClusterAnswer answer = network.run(budget);
    network.read_outputs(pair_probability);
    return answer;
  }

 private:
  HnpdaOptions options_;
};

}  // namespace

std::unique_ptr<Associator> make_hnpda(const HnpdaOptions& options) {
  return make_scan_marginals(std::make_unique<Hnpda>(options), {});
}

}  // namespace mda
