#include "algorithms/marginal/frontier_kernel.h"

#include <bit>

namespace mda {
namespace {

/// Four numbers that the compiler adds and multiplies side by side, on any processor.
using Four [[gnu::vector_size(32), gnu::may_alias]] = double;

constexpr std::size_t kFours = kChunk / 4;

/// The gated bits beyond the chunk, as bits of a chunk's number.
std::uint32_t far_bits(const LayerWeights& weights) { return weights.gated >> kChunkBits; }

[[gnu::always_inline]] inline const Four* chunk_of(const double* values, std::size_t chunk) {
  return reinterpret_cast<const Four*>(values + chunk * kChunk);
}

[[gnu::always_inline]] inline Four* chunk_of(double* values, std::size_t chunk) {
  return reinterpret_cast<Four*>(values + chunk * kChunk);
}

[[gnu::always_inline]] inline void clear(Four* chunk) {
  for (std::size_t i = 0; i < kFours; ++i) chunk[i] = Four{};
}

/// Sets of one chunk differ in bits 0 and 1 within a Four, in bits 2 and 3 between them.
[[gnu::always_inline]] inline void forward_body(const LayerWeights& weights, std::size_t chunks,
                                                int most, const double* f, double* g) {
  const double none = weights.none;
  const Four w0 = {0.0, weights.bit[0], 0.0, weights.bit[0]};
  const Four w1 = {0.0, 0.0, weights.bit[1], weights.bit[1]};
  const double w2 = weights.bit[2];
  const double w3 = weights.bit[3];
  const std::uint32_t far = far_bits(weights);
  for (std::size_t c = 0; c < chunks; ++c) {
    Four* out = chunk_of(g, c);
    if (std::popcount(c) > most) {
      clear(out);
      continue;
    }
    const Four* in = chunk_of(f, c);
    Four sum[kFours];
    for (std::size_t i = 0; i < kFours; ++i) {
      sum[i] = none * in[i] + w0 * __builtin_shufflevector(in[i], in[i], 0, 0, 2, 2) +
               w1 * __builtin_shufflevector(in[i], in[i], 0, 1, 0, 1);
    }
    sum[1] += w2 * in[0];
    sum[3] += w2 * in[2];
    sum[2] += w3 * in[0];
    sum[3] += w3 * in[1];
    for (auto left = static_cast<std::uint32_t>(c) & far; left != 0; left &= left - 1) {
      const int t = std::countr_zero(left);
      const double w = weights.bit[static_cast<std::size_t>(t + kChunkBits)];
      const Four* from = chunk_of(f, c ^ (std::size_t{1} << t));
      for (std::size_t i = 0; i < kFours; ++i) sum[i] += w * from[i];
    }
    for (std::size_t i = 0; i < kFours; ++i) out[i] = sum[i];
  }
}

[[gnu::always_inline]] inline void backward_body(const LayerWeights& weights, std::size_t chunks,
                                                 int most, const double* f, const double* b,
                                                 double* g, LayerSums& sums) {
  const double none = weights.none;
  const Four w0 = {weights.bit[0], 0.0, weights.bit[0], 0.0};
  const Four w1 = {weights.bit[1], weights.bit[1], 0.0, 0.0};
  const double w2 = weights.bit[2];
  const double w3 = weights.bit[3];
  const std::uint32_t far = far_bits(weights);
  Four total[kMostFrontierBits] = {};
  Four total_none = {};
  Four near[kChunkBits] = {};
  for (std::size_t c = 0; c < chunks; ++c) {
    Four* out = chunk_of(g, c);
    if (std::popcount(c) > most) {
      clear(out);
      continue;
    }
    const Four* ahead = chunk_of(b, c);
    const Four* behind = chunk_of(f, c);
    Four sum[kFours];
    for (std::size_t i = 0; i < kFours; ++i) {
      const Four one = __builtin_shufflevector(ahead[i], ahead[i], 1, 1, 3, 3);
      const Four two = __builtin_shufflevector(ahead[i], ahead[i], 2, 3, 2, 3);
      sum[i] = none * ahead[i] + w0 * one + w1 * two;
      total_none += behind[i] * ahead[i];
      near[0] += behind[i] * one;
      near[1] += behind[i] * two;
    }
    sum[0] += w2 * ahead[1] + w3 * ahead[2];
    sum[1] += w3 * ahead[3];
    sum[2] += w2 * ahead[3];
    near[2] += behind[0] * ahead[1] + behind[2] * ahead[3];
    near[3] += behind[0] * ahead[2] + behind[1] * ahead[3];
    for (auto left = ~static_cast<std::uint32_t>(c) & far; left != 0; left &= left - 1) {
      const auto t = static_cast<std::size_t>(std::countr_zero(left));
      const double w = weights.bit[t + kChunkBits];
      const Four* from = chunk_of(b, c | (std::size_t{1} << t));
      for (std::size_t i = 0; i < kFours; ++i) sum[i] += w * from[i];
      total[t] +=
          (behind[0] * from[0] + behind[1] * from[1]) + (behind[2] * from[2] + behind[3] * from[3]);
    }
    for (std::size_t i = 0; i < kFours; ++i) out[i] = sum[i];
  }
  sums.none = (total_none[0] + total_none[1]) + (total_none[2] + total_none[3]);
  sums.bit[0] = near[0][0] + near[0][2];
  sums.bit[1] = near[1][0] + near[1][1];
  sums.bit[2] = (near[2][0] + near[2][1]) + (near[2][2] + near[2][3]);
  sums.bit[3] = (near[3][0] + near[3][1]) + (near[3][2] + near[3][3]);
  for (std::size_t t = 0; t + kChunkBits < kMostFrontierBits; ++t) {
    sums.bit[t + kChunkBits] = (total[t][0] + total[t][1]) + (total[t][2] + total[t][3]);
  }
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
