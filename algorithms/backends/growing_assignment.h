// The best set of disjoint paths through scans that arrive one by one.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/backends/one_sided.h"

namespace mda {

/// Each detection chooses what comes before it (path_reduction.h), so a new scan brings agents and
/// objects but changes nothing of what older ones chose from: their duals stay feasible, and
/// matching the new agents is all there is to do. Memory grows with the scans.
class GrowingAssignment {
 public:
  static constexpr int kNone = -1;

  GrowingAssignment() : matcher_(problem_) {}
  GrowingAssignment(const GrowingAssignment&) = delete;
  GrowingAssignment& operator=(const GrowingAssignment&) = delete;

  /// A detection that a path may use at `cost`, start with at `entry` and end with at `exit`.
  /// Returns its number, counted from 0. Throws std::invalid_argument if a cost is beyond
  /// INT64_MAX / 64.
  int add_detection(std::int64_t cost, std::int64_t entry, std::int64_t exit);

  /// Lets paths go from an older detection to the newest one, at `cost`. Throws
  /// std::invalid_argument if `from` is not older or the cost out of range.
  void add_link(int from, std::int64_t cost);

  /// Call after the last link of a scan; everything below is about the last call.
  void update() { matcher_.match(); }

  /// Of the optimal set of paths. O(detections). Throws std::overflow_error outside 64 bits.
  [[nodiscard]] std::int64_t cost() const;
  [[nodiscard]] bool is_used(int detection) const { return matcher_.owner(detection) != detection; }
  /// The next detection on the path, or kNone: it ends here. For detections that are used.
  [[nodiscard]] int next(int detection) const { return matcher_.owner(detection); }
  /// The first detection of every path, in the order of time.
  [[nodiscard]] std::vector<int> starts() const;

  /// Potentials of the nodes at a detection's two ends; those of source and sink are 0. Together
  /// they prove cost() (FlowResult::potential).
  [[nodiscard]] std::int64_t entry_potential(int detection) const {
    return matcher_.value(detection);
  }
  [[nodiscard]] std::int64_t exit_potential(int detection) const {
    return -matcher_.price(detection);
  }

 private:
  std::vector<std::int64_t> cost_;  ///< per detection
  OneSidedProblem problem_;
  OneSidedMatcher matcher_;
};

}  // namespace mda
