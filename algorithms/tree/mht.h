// Multiple hypothesis tracking over a window: whole hypotheses, scan after scan.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

struct MhtOptions {
  int hypotheses = 100;  ///< k: how many are kept per cluster and scan, at least 1
  /// Hypotheses that cost so much more than the best of their cluster are dropped. Not negative.
  double ratio_nats = 20.0;
};

/// A global hypothesis is a set of nodes of one layer of the HypothesisTree, one per track that is
/// alive; what they do not use are false alarms. Clusters (the connected components of the problem)
/// have hypotheses of their own. With every scan each hypothesis is extended by the ranked
/// assignments of its tracks to the plots: a track takes one of its children with a plot, or else
/// misses; a plot that no track takes starts a track, where the tree has one, or is a false alarm.
/// The k cheapest of all are taken from one queue over the assignments of all hypotheses; those
/// with the same nodes are one. In the end the best hypothesis of every cluster gives the columns,
/// without the tracks that are worth less than false alarms (or, of a fixed track, than coasting).
///
/// A track may be dropped, and its cost refunded, at any scan. It is only done where a track has no
/// child to miss with, or in the end: a track that misses can still be dropped later, so until then
/// it does what dropping it would do, and dropping both ways would fill the k places with copies.
///
/// Costs are partial costs: a track that begins costs first and gains with its later plots. Ranking
/// by them loses newborn tracks where a cluster has many plots that may be one, unless k is large;
/// `ratio_nats` must be several times the cost of a birth. With all hypotheses kept, the answer is
/// optimal. With one scan it always is.
///
/// Declines problems without a tree, and those that are not always feasible. Status kFeasible:
/// there is no proof. Clusters that are not finished at the deadline keep no tracks. Per cluster
/// and scan at most k² assignments are taken (mostly about k), see RankedAssignments. Throws
/// std::invalid_argument if an option is out of its range.
/// Source: Reid 1979, An algorithm for tracking multiple targets, IEEE Transactions on Automatic
/// Control 24; Cox and Hingorani 1996, An efficient implementation of Reid's multiple hypothesis
/// tracking algorithm and its evaluation for the purpose of visual tracking, IEEE PAMI 18.
[[nodiscard]] std::unique_ptr<Associator> make_mht(const MhtOptions& options);

}  // namespace mda
