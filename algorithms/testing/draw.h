// A small generator of pseudo-random numbers that gives the same numbers everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mda::testing {

/// Steps a 64-bit counter and scrambles it (the SplitMix64 construction). The standard library's
/// distributions differ between implementations, so there are none here.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() noexcept {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  /// In [0, 1), a multiple of 2^-53.
  double unit() noexcept { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// In 0..n-1, n > 0.
  int below(int n) noexcept { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }

  bool chance(double probability) noexcept { return unit() < probability; }

  /// 0..n-1 in random order.
  std::vector<int> permutation(int n) {
    std::vector<int> order(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
      order[static_cast<std::size_t>(i)] = i;
      std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(below(i + 1))]);
    }
    return order;
  }

 private:
  std::uint64_t state_;
};

}  // namespace mda::testing
