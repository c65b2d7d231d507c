#include "algorithms/marginal/jpda_enumerate.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/marginal/scan_marginals.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kMostComponentColumns = 30;

class JpdaEnumerate final : public ClusterMethod {
 public:
  [[nodiscard]] ClusterAnswer solve(const Cluster& cluster, const Budget& budget,
                                    std::span<double> pair_probability) override {
    budget_ = &budget;
    taken_.assign(index(cluster.plots), 0);
    chosen_.clear();
    events_ = 0;
    expired_ = false;
    best_ = 0.0;
    visit(cluster, 0, 0.0, [this](double log_weight) { best_ = std::max(best_, log_weight); });
    ClusterAnswer answer{.events = events_};
    double total = 0.0;
    std::fill(pair_probability.begin(), pair_probability.end(), 0.0);
    visit(cluster, 0, 0.0, [&](double log_weight) {
      const double weight = std::exp(log_weight - best_);
      total += weight;
      for (const int p : chosen_) pair_probability[index(p)] += weight;
    });
    for (double& value : pair_probability) value /= total;
    if (expired_) answer = {.known = false, .stop = Stop::kDeadline};
    return answer;
  }

 private:
  /// Calls at_event(ln of its weight) with every event that goes on from what tracks before `track`
  /// have chosen.
  template <typename AtEvent>
  void visit(const Cluster& cluster, int track, double log_weight, const AtEvent& at_event) {
    if (expired_) return;
    if (track == cluster.tracks()) {
      constexpr std::int64_t kEventsBetweenLooks = 1024;
      if (++events_ % kEventsBetweenLooks == 0) expired_ = budget_->expired();
      at_event(log_weight);
      return;
    }
    visit(cluster, track + 1, log_weight, at_event);
    for (int p = cluster.track_begin[index(track)]; p < cluster.track_begin[index(track) + 1];
         ++p) {
      char& taken = taken_[index(cluster.plot[index(p)])];
      if (taken != 0) continue;
      taken = 1;
      chosen_.push_back(p);
      visit(cluster, track + 1, log_weight + cluster.log_weight[index(p)], at_event);
      chosen_.pop_back();
      taken = 0;
    }
  }

  const Budget* budget_ = nullptr;
  std::vector<char> taken_;
  std::vector<int> chosen_;  ///< pairs
  std::int64_t events_ = 0;
  double best_ = 0.0;  ///< ln of the largest weight of an event
  bool expired_ = false;
};

}  // namespace

std::unique_ptr<Associator> make_jpda_enumerate() {
  return make_scan_marginals(std::make_unique<JpdaEnumerate>(),
                             {.consistent = true, .most_component_columns = kMostComponentColumns});
}

}  // namespace mda
