// What the single-scan methods for marginals have in common: everything but the probabilities of
// the pairs of one cluster.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "algorithms/api/associator.h"
#include "algorithms/marginal/scan_weights.h"

namespace mda {

struct ClusterAnswer {
  bool known = true;  ///< otherwise the whole problem has no answer, for the reason in `note`
  Stop stop = Stop::kFinished;
  std::optional<std::int64_t> iterations = std::nullopt;
  std::optional<std::int64_t> events = std::nullopt;  ///< choices looked at one by one
  std::string note = {};
};

class ClusterMethod {
 public:
  ClusterMethod() = default;
  ClusterMethod(const ClusterMethod&) = delete;
  ClusterMethod& operator=(const ClusterMethod&) = delete;
  virtual ~ClusterMethod() = default;

  /// Writes the probability of every pair.
  [[nodiscard]] virtual ClusterAnswer solve(const Cluster& cluster, const Budget& budget,
                                            std::span<double> pair_probability) = 0;
};

struct ScanMarginalsOptions {
  bool consistent = false;  ///< Traits::consistent
  int most_component_columns = std::numeric_limits<int>::max();
};

/// An entry of the catalogue out of a method for clusters. Takes always feasible problems of two
/// dimensions at most: fixed tracks and one scan, or two scans or sensors, whose first one then is
/// in the tracks' place. The status of an answer is kFeasible: marginals are no optimum of
/// anything. Stats::iterations is that of the slowest cluster, Stats::nodes the sum of the events.
[[nodiscard]] std::unique_ptr<Associator> make_scan_marginals(std::unique_ptr<ClusterMethod> method,
                                                              const ScanMarginalsOptions& options);

}  // namespace mda
