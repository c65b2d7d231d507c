// Joint probabilistic data association: exact marginals.
#pragma once

#include <cstdint>
#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// Which rows of a cluster the dynamic programme keeps a mask of.
enum class Masked : std::uint8_t {
  kCheaper,  ///< whichever takes less work
  kTracks,
  kPlots
};

struct JpdaOptions {
  Masked masked = Masked::kCheaper;
  int most_masked = 22;          ///< rows in the mask at one time, 32 at most
  double most_bytes = 1.5e9;     ///< of memory for one cluster
  bool portable_kernel = false;  ///< for tests: as on a processor without wide vectors
};

/// The probability of every column if choices are as probable as exp(-cost): the sum over all
/// feasible events, cluster by cluster, by dynamic programming over masks of the rows that are
/// still of interest (FrontierSum). Linear in the rows, exponential in the width of the frontier,
/// which is known before the sum starts: beyond a cap there is no answer, and the note says so.
/// Relative errors stay below 1e-12 for costs up to some hundred nats; that of the weights
/// themselves, 1e-16 per nat, comes on top. Keeps its memory. Source: the question is that of
/// Fortmann, Bar-Shalom and Scheffe, IEEE Journal of Oceanic Engineering 8 (1983); the method is
/// derived in frontier_sum.h.
[[nodiscard]] std::unique_ptr<Associator> make_jpda(const JpdaOptions& options);

}  // namespace mda
