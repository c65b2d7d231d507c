#include "algorithms/marginal/frontier_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// The frontier while layers are processed one after another.
class Frontier {
 public:
  /// `ranked`: the layers in the order that settles ties.
  Frontier(const Incidence& incidence, const std::vector<int>& ranked)
      : incidence_(incidence),
        rank_(index(incidence.layers()), 0),
        done_(index(incidence.layers()), 0),
        opens_(index(incidence.layers()), 0),
        closes_(index(incidence.layers()), 0),
        open_(index(incidence.bits()), 0),
        left_(index(incidence.bits()), 0) {
    for (int l = 0; l < incidence.layers(); ++l) {
      for_each_shared_bit(l, [&](int) { ++opens_[index(l)]; });
    }
    shared_ = opens_;
    int rank = 0;
    for (const int l : ranked) rank_[index(l)] = rank++;
    for (int b = 0; b < incidence.bits(); ++b) {
      left_[index(b)] = incidence.bit_begin[index(b) + 1] - incidence.bit_begin[index(b)];
    }
  }

  void process(int layer) {
    done_[index(layer)] = 1;
    order_.layers.push_back(layer);
    width_ += opens_[index(layer)];
    order_.width = std::max(order_.width, width_);
    const int pairs =
        incidence_.layer_begin[index(layer) + 1] - incidence_.layer_begin[index(layer)];
    order_.work += std::ldexp(3.0 * (pairs + 1), width_);
    for_each_shared_bit(layer, [this](int b) { pass(b); });
  }

  /// Of the layers that share a bit with the frontier, if there are any, the one that opens least
  /// beyond what it closes, among them the one of the lowest rank.
  [[nodiscard]] int next() const {
    int best = -1;
    std::tuple<bool, int, int> least;
    for (int l = 0; l < incidence_.layers(); ++l) {
      if (done_[index(l)] != 0) continue;
      const int opens = opens_[index(l)];
      const std::tuple key{opens > 0 && opens == shared_[index(l)], opens - closes_[index(l)],
                           rank_[index(l)]};
      if (best >= 0 && key >= least) continue;
      least = key;
      best = l;
    }
    return best;
  }

  [[nodiscard]] FrontierOrder& order() noexcept { return order_; }

 private:
  template <typename Visit>
  void for_each_shared_bit(int layer, const Visit& visit) const {
    for (int e = incidence_.layer_begin[index(layer)]; e < incidence_.layer_begin[index(layer) + 1];
         ++e) {
      const int b = incidence_.bit[index(e)];
      if (!incidence_.is_private(b)) visit(b);
    }
  }

  /// One layer of the bit has been processed.
  void pass(int b) {
    const int begin = incidence_.bit_begin[index(b)];
    const int end = incidence_.bit_begin[index(b) + 1];
    if (std::exchange(open_[index(b)], 1) == 0) {
      for (int i = begin; i < end; ++i) --opens_[index(incidence_.layer_of_bit[index(i)])];
    }
    if (--left_[index(b)] == 0) --width_;
    if (left_[index(b)] != 1) return;
    for (int i = begin; i < end; ++i) {
      const int l = incidence_.layer_of_bit[index(i)];
      if (done_[index(l)] == 0) ++closes_[index(l)];
    }
  }

  const Incidence& incidence_;
  FrontierOrder order_;
  int width_ = 0;
  std::vector<int> rank_;    ///< per layer
  std::vector<char> done_;   ///< per layer
  std::vector<int> shared_;  ///< per layer: its bits that are not private
  std::vector<int> opens_;   ///< per layer: bits that it would add to the mask
  std::vector<int> closes_;  ///< per layer: bits that need no other layer any more
  std::vector<char> open_;   ///< per bit: has been in the mask
  std::vector<int> left_;    ///< per bit: layers to come
};

/// The layers by their distance from `start`, in steps from a layer to one that shares a bit with
/// it. O(pairs).
std::vector<int> by_distance(const Incidence& incidence, int start) {
  std::vector<char> seen(index(incidence.layers()), 0);
  std::vector<char> bit_seen(index(incidence.bits()), 0);
  std::vector<int> layers = {start};
  seen[index(start)] = 1;
  for (std::size_t next = 0; next < layers.size(); ++next) {
    const int l = layers[next];
    for (int e = incidence.layer_begin[index(l)]; e < incidence.layer_begin[index(l) + 1]; ++e) {
      const int b = incidence.bit[index(e)];
      if (std::exchange(bit_seen[index(b)], 1) != 0) continue;
      for (int i = incidence.bit_begin[index(b)]; i < incidence.bit_begin[index(b) + 1]; ++i) {
        const int other = incidence.layer_of_bit[index(i)];
        if (std::exchange(seen[index(other)], 1) == 0) layers.push_back(other);
      }
    }
  }
  return layers;
}

/// Layers to begin with: first two that are far from each other, at the ends of a long cluster.
std::vector<int> starts_of(const Incidence& incidence) {
  constexpr double kMostSteps = 4e6;
  constexpr int kMostStarts = 8;
  const int layers = incidence.layers();
  const double affordable = kMostSteps / (1.0 + layers) / (1.0 + layers);
  const int count = std::min({layers, kMostStarts, 2 + static_cast<int>(affordable)});
  std::vector<int> starts = {by_distance(incidence, 0).back()};
  starts.push_back(by_distance(incidence, starts.front()).back());
  for (int s = 2; s < count; ++s) {
    starts.push_back(static_cast<int>(static_cast<long long>(s - 1) * layers / (count - 1)));
  }
  return starts;
}

}  // namespace

Incidence incidence_of(const Cluster& cluster, bool mask_tracks) {
  const int layers = mask_tracks ? cluster.plots : cluster.tracks();
  const int bits = mask_tracks ? cluster.tracks() : cluster.plots;
  Incidence result;
  result.layer_begin.assign(index(layers) + 1, 0);
  result.bit_begin.assign(index(bits) + 1, 0);
  const auto for_each_pair = [&](const auto& visit) {
    for (int t = 0; t < cluster.tracks(); ++t) {
      for (int p = cluster.track_begin[index(t)]; p < cluster.track_begin[index(t) + 1]; ++p) {
        const int j = cluster.plot[index(p)];
        visit(p, mask_tracks ? j : t, mask_tracks ? t : j);
      }
    }
  };
  for_each_pair([&](int, int layer, int bit) {
    ++result.layer_begin[index(layer) + 1];
    ++result.bit_begin[index(bit) + 1];
  });
  std::partial_sum(result.layer_begin.begin(), result.layer_begin.end(),
                   result.layer_begin.begin());
  std::partial_sum(result.bit_begin.begin(), result.bit_begin.end(), result.bit_begin.begin());
  result.bit.resize(index(cluster.pairs()));
  result.pair.resize(index(cluster.pairs()));
  result.layer_of_bit.resize(index(cluster.pairs()));
  std::vector<int> next_entry = result.layer_begin;
  std::vector<int> next_layer = result.bit_begin;
  for_each_pair([&](int p, int layer, int bit) {
    const int entry = next_entry[index(layer)]++;
    result.bit[index(entry)] = bit;
    result.pair[index(entry)] = p;
    result.layer_of_bit[index(next_layer[index(bit)]++)] = layer;
  });
  return result;
}

FrontierOrder find_frontier_order(const Incidence& incidence) {
  FrontierOrder best;
  const auto is_better = [&](const FrontierOrder& order) {
    return best.layers.empty() || order.work < best.work;
  };
  for (const int start : starts_of(incidence)) {
    const std::vector<int> ranked = by_distance(incidence, start);
    Frontier greedy(incidence, ranked);
    greedy.process(start);
    while (std::ssize(greedy.order().layers) < incidence.layers() && is_better(greedy.order())) {
      greedy.process(greedy.next());
    }
    if (is_better(greedy.order())) best = std::move(greedy.order());
  }
  return best;
}

}  // namespace mda
