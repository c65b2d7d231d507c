#include "algorithms/marginal/frontier_plan.h"

#include <algorithm>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

class Planner {
 public:
  Planner(const Incidence& incidence, const FrontierWeights& weights)
      : incidence_(incidence), weights_(weights) {
    for (int b = 0; b < incidence.bits(); ++b) {
      left_.push_back(incidence.bit_begin[index(b) + 1] - incidence.bit_begin[index(b)]);
    }
  }

  [[nodiscard]] FrontierStep step(int layer) {
    FrontierStep step;
    open_bits(layer, step);
    step.width = static_cast<int>(mask_.size());
    const double privates_free = weigh_privates(layer, step);
    for_each_entry(layer, [&](int bit, int pair) {
      if (incidence_.is_private(bit)) return;
      const int slot = slot_of(bit);
      step.pairs.push_back({slot, pair});
      step.weights.bit[index(slot)] = weights_.pair[index(pair)] * privates_free;
      step.weights.gated |= std::uint32_t{1} << slot;
      --left_[index(bit)];
    });
    close_bits(step);
    return step;
  }

 private:
  template <typename Visit>
  void for_each_entry(int layer, const Visit& visit) const {
    for (int e = incidence_.layer_begin[index(layer)]; e < incidence_.layer_begin[index(layer) + 1];
         ++e) {
      visit(incidence_.bit[index(e)], incidence_.pair[index(e)]);
    }
  }

  [[nodiscard]] int slot_of(int bit) const {
    return static_cast<int>(std::find(mask_.begin(), mask_.end(), bit) - mask_.begin());
  }

  void open_bits(int layer, FrontierStep& step) {
    for_each_entry(layer, [&](int bit, int) {
      if (incidence_.is_private(bit) || slot_of(bit) < static_cast<int>(mask_.size())) return;
      mask_.push_back(bit);
      ++step.opened;
    });
  }

  /// The layer takes none of the mask: it is free, or takes one private bit, and the others are
  /// free. Returns the weight of all private bits being free.
  double weigh_privates(int layer, FrontierStep& step) {
    double all_free = 1.0;
    for_each_entry(layer, [&](int bit, int pair) {
      if (!incidence_.is_private(bit)) return;
      const double free = weights_.free_bit[index(bit)];
      const double weight = weights_.pair[index(pair)];
      for (PrivatePair& other : step.privates) other.weight *= free;
      step.privates.push_back({weight * all_free, pair});
      all_free *= free;
    });
    step.weights.none = weights_.free_layer[index(layer)] * all_free;
    for (const PrivatePair& one : step.privates) step.weights.none += one.weight;
    return all_free;
  }

  void close_bits(FrontierStep& step) {
    for (int slot = step.width - 1; slot >= 0; --slot) {
      const int bit = mask_[index(slot)];
      if (left_[index(bit)] > 0) continue;
      step.closings.push_back({slot, weights_.free_bit[index(bit)]});
      mask_.erase(mask_.begin() + slot);
    }
  }

  const Incidence& incidence_;
  const FrontierWeights& weights_;
  std::vector<int> mask_;  ///< bits
  std::vector<int> left_;  ///< per bit: layers to come
};

}  // namespace

std::vector<FrontierStep> plan_frontier(const Incidence& incidence, const FrontierOrder& order,
                                        const FrontierWeights& weights) {
  Planner planner(incidence, weights);
  std::vector<FrontierStep> steps;
  steps.reserve(order.layers.size());
  for (const int layer : order.layers) steps.push_back(planner.step(layer));
  return steps;
}

}  // namespace mda
