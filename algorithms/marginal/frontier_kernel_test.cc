#include "algorithms/marginal/frontier_kernel.h"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "algorithms/testing/draw.h"

namespace mda {
namespace {

/// Values over the sets of some bits, aligned as the kernels want them.
class Values {
 public:
  explicit Values(std::size_t size) : chunks_(size / kChunk), size_(size) {}

  double* data() { return chunks_.front().value; }
  double& operator[](std::size_t set) { return chunks_[set / kChunk].value[set % kChunk]; }
  [[nodiscard]] std::size_t chunks() const { return chunks_.size(); }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::vector<double> all() { return {data(), data() + size_}; }

 private:
  struct alignas(64) Chunk {
    double value[kChunk] = {};
  };
  std::vector<Chunk> chunks_;
  std::size_t size_;
};

struct LayerCase {
  int width;
  int most;
  LayerWeights weights;
  Values f;
  Values b;

  explicit LayerCase(std::uint64_t seed)
      : width(kChunkBits + static_cast<int>(seed % 6)),
        most(static_cast<int>(seed % 5)),
        f(std::size_t{1} << width),
        b(std::size_t{1} << width) {
    testing::Draw draw(seed);
    weights.none = draw.unit();
    for (int t = 0; t < width; ++t) {
      if (draw.chance(0.3)) continue;
      weights.bit[static_cast<std::size_t>(t)] = draw.unit();
      weights.gated |= std::uint32_t{1} << t;
    }
    for (std::size_t s = 0; s < f.size(); ++s) {
      f[s] = matters(s, most) ? draw.unit() : 0.0;
      b[s] = draw.unit();
    }
  }

  [[nodiscard]] bool gated(int t) const { return ((weights.gated >> t) & 1U) != 0; }

  static bool matters(std::size_t set, int most_bits) {
    return std::popcount(set >> kChunkBits) <= most_bits;
  }
};

/// As the header defines it, set by set.
void expect_as_defined(const FrontierKernel& kernel, LayerCase& c) {
  Values forward(c.f.size());
  Values backward(c.f.size());
  LayerSums sums;
  kernel.forward(c.weights, c.f.chunks(), c.most + 1, c.f.data(), forward.data());
  kernel.backward(c.weights, c.f.chunks(), c.most, c.f.data(), c.b.data(), backward.data(), sums);
  LayerSums expected;
  for (std::size_t s = 0; s < c.f.size(); ++s) {
    double ahead = c.weights.none * c.f[s];
    double behind = c.weights.none * c.b[s];
    expected.none += c.f[s] * c.b[s];
    for (int t = 0; t < c.width; ++t) {
      const std::size_t other = s ^ (std::size_t{1} << t);
      const double weight = c.weights.bit[static_cast<std::size_t>(t)];
      if (other < s) {
        ahead += weight * c.f[other];
      } else {
        behind += weight * c.b[other];
        expected.bit[static_cast<std::size_t>(t)] += c.f[s] * c.b[other];
      }
    }
    EXPECT_NEAR(forward[s], LayerCase::matters(s, c.most + 1) ? ahead : 0.0, 1e-14);
    EXPECT_NEAR(backward[s], LayerCase::matters(s, c.most) ? behind : 0.0, 1e-14);
  }
  EXPECT_NEAR(sums.none, expected.none, 1e-12);
  for (int t = 0; t < c.width; ++t) {
    if (!c.gated(t)) continue;
    const auto i = static_cast<std::size_t>(t);
    EXPECT_NEAR(sums.bit[i], expected.bit[i], 1e-12) << "bit " << t;
  }
}

TEST(FrontierKernel, DoesOneLayerAsDefined) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    LayerCase c(seed);
    expect_as_defined(fastest_frontier_kernel(), c);
    expect_as_defined(portable_frontier_kernel(), c);
  }
}

TEST(FrontierKernel, GivesTheSameBitsOnAnyProcessor) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    LayerCase c(seed);
    Values fast(c.f.size());
    Values slow(c.f.size());
    LayerSums fast_sums;
    LayerSums slow_sums;
    const std::size_t chunks = c.f.chunks();
    fastest_frontier_kernel().forward(c.weights, chunks, c.most + 1, c.f.data(), fast.data());
    portable_frontier_kernel().forward(c.weights, chunks, c.most + 1, c.f.data(), slow.data());
    EXPECT_EQ(fast.all(), slow.all());
    fastest_frontier_kernel().backward(c.weights, chunks, c.most, c.f.data(), c.b.data(),
                                       fast.data(), fast_sums);
    portable_frontier_kernel().backward(c.weights, chunks, c.most, c.f.data(), c.b.data(),
                                        slow.data(), slow_sums);
    EXPECT_EQ(fast.all(), slow.all());
    EXPECT_EQ(fast_sums.none, slow_sums.none);
    EXPECT_EQ(fast_sums.bit, slow_sums.bit);
  }
}

}  // namespace
}  // namespace mda
