// One scan as the marginal methods see it: clusters of weighted pairs. The weight of a choice of
// columns is exp(-cost), and its probability is in proportion to that.
#pragma once

#include <span>
#include <vector>

#include "algorithms/api/problem.h"

namespace mda {

/// Tracks and plots that gated pairs connect; both are numbered from 0. Tracks are the rows of the
/// lowest dimension. Pairs are ordered by track; columns of one pair are merged.
struct Cluster {
  std::vector<int> track_begin = {
      0};                 ///< pairs of track t: track_begin[t] up to track_begin[t + 1]
  std::vector<int> plot;  ///< per pair
  /// Per pair, nats: ln of its weight over those of what its track and its plot do otherwise, so
  /// that a free row weighs 1.
  std::vector<double> log_weight;
  int plots = 0;

  [[nodiscard]] int tracks() const noexcept { return static_cast<int>(track_begin.size()) - 1; }
  [[nodiscard]] int pairs() const noexcept { return static_cast<int>(plot.size()); }
};

/// Reads a problem of two dimensions at most and always feasible. What a row does when it is in no
/// pair weighs the sum over its columns alone, and 1 more (nothing, clutter) if the row is at most
/// once. Sums of weights are kept as logarithms: any finite cost will do.
class ScanWeights {
 public:
  /// O(nonzeros log nonzeros). Forgets the problem before.
  void read(const AssociationProblem& problem);

  /// In the order of their first column; rows in no pair are in none.
  [[nodiscard]] std::span<const Cluster> clusters() const noexcept { return clusters_; }

  /// The probability of every column, given those of the pairs, cluster after cluster. A row is
  /// free with the probability that its pairs leave, which its columns alone share by weight.
  [[nodiscard]] std::vector<double> columns(std::span<const double> pair_probability) const;

 private:
  void weigh_rests(const AssociationProblem& problem);
  void merge_pairs(const AssociationProblem& problem);
  void add_pair(int track_row, int plot_row);

  std::vector<Cluster> clusters_;
  std::vector<double> rest_;         ///< per row: ln of the weight of being in no pair
  std::vector<int> pair_of_column_;  ///< over all clusters, or kNone
  std::vector<int> first_row_;       ///< per column
  std::vector<int> pair_track_row_;
  std::vector<int> pair_plot_row_;
  std::vector<double> share_;       ///< per column: of its pair's, or of its free row's weight
  std::vector<int> number_of_row_;  ///< in its cluster
};

}  // namespace mda
