// The inner loops of exact marginals: one layer of the dynamic programme over sets of masked rows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace mda {

inline constexpr int kMostFrontierBits = 32;

/// Arrays over sets hold 2^bits values, at least a chunk of this many; bits beyond those in use
/// weigh 0 and are in no set of a value other than 0. They are aligned to 64 bytes.
inline constexpr int kChunkBits = 4;
inline constexpr std::size_t kChunk = std::size_t{1} << kChunkBits;

/// What a layer does: it takes no bit, or one.
struct LayerWeights {
  double none = 0.0;
  std::array<double, kMostFrontierBits> bit{};  ///< 0: not gated
  std::uint32_t gated = 0;                      ///< the bits that are
};

/// Sums over all sets S.
struct LayerSums {
  double none = 0.0;                            ///< of f[S] b[S]
  std::array<double, kMostFrontierBits> bit{};  ///< of f[S] b[S + t], of sets without t
};

/// Sets of more than `most` bits, counting those beyond the chunk only, are known not to matter:
/// what is written for them is 0.
struct FrontierKernel {
  /// g[S] = none f[S] + sum over t in S of bit[t] f[S - t].
  void (*forward)(const LayerWeights& weights, std::size_t chunks, int most, const double* f,
                  double* g);
  /// g[S] = none b[S] + sum over t not in S of bit[t] b[S + t], and the sums; O(gated * 2^bits).
  void (*backward)(const LayerWeights& weights, std::size_t chunks, int most, const double* f,
                   const double* b, double* g, LayerSums& sums);
};

/// The fastest one on this processor. All kernels do the same operations in the same order, none
/// fused: the same bits everywhere.
[[nodiscard]] const FrontierKernel& fastest_frontier_kernel() noexcept;

/// The one for any processor.
[[nodiscard]] const FrontierKernel& portable_frontier_kernel() noexcept;

}  // namespace mda
