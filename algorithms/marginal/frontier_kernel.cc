#include "algorithms/marginal/frontier_kernel.h"

#include <bit>
#include <iterator>

namespace mda {
namespace {

/// Four numbers that the compiler adds and multiplies side by side, on any processor.
using Four [[gnu::vector_size(32), gnu::may_alias]] = double;

/// Values of the 16 sets of one chunk. Sets within a Four differ in bits 0 and 1; bit 2 is between
/// a and b, c and d, bit 3 between a and c, b and d.
struct Chunk {
  Four a;
  Four b;
  Four c;
  Four d;
};

static_assert(sizeof(Chunk) == kChunk * sizeof(double));

/// The gated bits beyond the chunk, as bits of a chunk's number.
std::uint32_t far_bits(const LayerWeights& weights) { return weights.gated >> kChunkBits; }

[[gnu::always_inline]] inline void add(Chunk& sum, double weight, const Chunk& from) {
  sum.a += weight * from.a;
  sum.b += weight * from.b;
  sum.c += weight * from.c;
  sum.d += weight * from.d;
}

[[gnu::always_inline]] inline void add_dot(Four& sum, const Chunk& f, const Chunk& b) {
  sum += (f.a * b.a + f.b * b.b) + (f.c * b.c + f.d * b.d);
}

[[gnu::always_inline]] inline void scale(Chunk& result, double weight, const Chunk& from) {
  result.a = weight * from.a;
  result.b = weight * from.b;
  result.c = weight * from.c;
  result.d = weight * from.d;
}

/// What sets get from those without bit 0, and without bit 1.
[[gnu::always_inline]] inline void take_within(Four& sum, const Four& w0, const Four& w1,
                                               const Four& f) {
  sum += w0 * __builtin_shufflevector(f, f, 0, 0, 2, 2);
  sum += w1 * __builtin_shufflevector(f, f, 0, 1, 0, 1);
}

/// The same from those with the bit; sum0 and sum1 add up f times what the set gets, where it does.
[[gnu::always_inline]] inline void give_within(Four& sum, Four& sum0, Four& sum1, const Four& w0,
                                               const Four& w1, const Four& f, const Four& b) {
  const Four with0 = __builtin_shufflevector(b, b, 1, 1, 3, 3);
  const Four with1 = __builtin_shufflevector(b, b, 2, 3, 2, 3);
  sum += w0 * with0;
  sum += w1 * with1;
  sum0 += f * with0;
  sum1 += f * with1;
}

[[gnu::always_inline]] inline void forward_body(const LayerWeights& weights, std::size_t chunks,
                                                int most, const double* f, double* g) {
  const Four w0 = {0.0, weights.bit[0], 0.0, weights.bit[0]};
  const Four w1 = {0.0, 0.0, weights.bit[1], weights.bit[1]};
  const std::uint32_t far = far_bits(weights);
  const auto* in = reinterpret_cast<const Chunk*>(f);
  auto* out = reinterpret_cast<Chunk*>(g);
  for (std::size_t c = 0; c < chunks; ++c) {
    if (std::popcount(c) > most) {
      out[c] = Chunk();
      continue;
    }
    const Chunk& from = in[c];
    Chunk sum;
    scale(sum, weights.none, from);
    take_within(sum.a, w0, w1, from.a);
    take_within(sum.b, w0, w1, from.b);
    take_within(sum.c, w0, w1, from.c);
    take_within(sum.d, w0, w1, from.d);
    sum.b += weights.bit[2] * from.a;
    sum.d += weights.bit[2] * from.c;
    sum.c += weights.bit[3] * from.a;
    sum.d += weights.bit[3] * from.b;
    for (auto left = static_cast<std::uint32_t>(c) & far; left != 0; left &= left - 1) {
      const auto t = static_cast<std::size_t>(std::countr_zero(left));
      add(sum, weights.bit[t + kChunkBits], in[c ^ (std::size_t{1} << t)]);
    }
    out[c] = sum;
  }
}

[[gnu::always_inline]] inline double total(const Four& values) {
  return (values[0] + values[1]) + (values[2] + values[3]);
}

[[gnu::always_inline]] inline void backward_body(const LayerWeights& weights, std::size_t chunks,
                                                 int most, const double* f, const double* b,
                                                 double* g, LayerSums& sums) {
  const Four w0 = {weights.bit[0], 0.0, weights.bit[0], 0.0};
  const Four w1 = {weights.bit[1], weights.bit[1], 0.0, 0.0};
  const std::uint32_t far = far_bits(weights);
  const auto* behind = reinterpret_cast<const Chunk*>(f);
  const auto* ahead = reinterpret_cast<const Chunk*>(b);
  auto* out = reinterpret_cast<Chunk*>(g);
  Four none = {};
  Four near[kChunkBits] = {};
  Four beyond[kMostFrontierBits - kChunkBits] = {};
  for (std::size_t c = 0; c < chunks; ++c) {
    if (std::popcount(c) > most) {
      out[c] = Chunk();
      continue;
    }
    const Chunk& at = behind[c];
    const Chunk& from = ahead[c];
    Chunk sum;
    scale(sum, weights.none, from);
    add_dot(none, at, from);
    give_within(sum.a, near[0], near[1], w0, w1, at.a, from.a);
    give_within(sum.b, near[0], near[1], w0, w1, at.b, from.b);
    give_within(sum.c, near[0], near[1], w0, w1, at.c, from.c);
    give_within(sum.d, near[0], near[1], w0, w1, at.d, from.d);
    sum.a += weights.bit[2] * from.b;
    sum.c += weights.bit[2] * from.d;
    sum.a += weights.bit[3] * from.c;
    sum.b += weights.bit[3] * from.d;
    near[2] += at.a * from.b + at.c * from.d;
    near[3] += at.a * from.c + at.b * from.d;
    for (auto left = ~static_cast<std::uint32_t>(c) & far; left != 0; left &= left - 1) {
      const auto t = static_cast<std::size_t>(std::countr_zero(left));
      const Chunk& other = ahead[c | (std::size_t{1} << t)];
      add(sum, weights.bit[t + kChunkBits], other);
      add_dot(beyond[t], at, other);
    }
    out[c] = sum;
  }
  sums.none = total(none);
  sums.bit[0] = near[0][0] + near[0][2];
  sums.bit[1] = near[1][0] + near[1][1];
  sums.bit[2] = total(near[2]);
  sums.bit[3] = total(near[3]);
  for (std::size_t t = 0; t < std::size(beyond); ++t) sums.bit[t + kChunkBits] = total(beyond[t]);
}

void forward_portable(const LayerWeights& weights, std::size_t chunks, int most, const double* f,
                      double* g) {
  forward_body(weights, chunks, most, f, g);
}

void backward_portable(const LayerWeights& weights, std::size_t chunks, int most, const double* f,
                       const double* b, double* g, LayerSums& sums) {
  backward_body(weights, chunks, most, f, b, g, sums);
}

constexpr FrontierKernel kPortable = {forward_portable, backward_portable};

#if defined(__x86_64__)

[[gnu::target("avx2,popcnt,bmi")]] void forward_avx2(const LayerWeights& weights,
                                                     std::size_t chunks, int most, const double* f,
                                                     double* g) {
  forward_body(weights, chunks, most, f, g);
}

[[gnu::target("avx2,popcnt,bmi")]] void backward_avx2(const LayerWeights& weights,
                                                      std::size_t chunks, int most, const double* f,
                                                      const double* b, double* g, LayerSums& sums) {
  backward_body(weights, chunks, most, f, b, g, sums);
}

constexpr FrontierKernel kAvx2 = {forward_avx2, backward_avx2};

#endif

}  // namespace

const FrontierKernel& portable_frontier_kernel() noexcept { return kPortable; }

const FrontierKernel& fastest_frontier_kernel() noexcept {
#if defined(__x86_64__)
  static const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0 &&
                               __builtin_cpu_supports("popcnt") != 0 &&
                               __builtin_cpu_supports("bmi") != 0;
  if (kHasAvx2) return kAvx2;
#endif
  return kPortable;
}

}  // namespace mda
