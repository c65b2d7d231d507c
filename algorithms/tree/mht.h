// Multiple hypothesis tracking over a window: whole hypotheses, scan after scan.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

struct MhtOptions {
  int hypotheses = 100;  ///< k: how many are kept per cluster and scan, at least 1
  /// Hypotheses that cost so much more than the best of their cluster are dropped. Not negative. A
  /// gate's width is too little, since a track that is better in the end may lag behind by some
  /// nats in every scan: in windows of up to 5 scans with few targets, 20 still lost an optimum now
  /// and then, 30 none, and took half the time of no limit.
  double ratio_nats = 30.0;
  /// Hypotheses are ranked by what the scans to come promise too. Not in the literature below.
  bool look_ahead = false;
};

/// A global hypothesis is a set of nodes of one layer of the HypothesisTree, one per track that is
/// alive. Clusters (the connected components of the problem) have hypotheses of their own. With
/// every scan each hypothesis is extended by the ranked assignments of its tracks to the plots: a
/// track takes one of its children with a plot, or else misses; a plot that no track takes starts
/// one, where the tree has one. The k cheapest of all are taken from one queue over the assignments
/// of all hypotheses; those with the same nodes are one. In the end the best hypothesis of every
/// cluster gives the columns, without the tracks that cost more than false alarms (or, of a fixed
/// track, than coasting from the beginning).
///
/// Dropping a track refunds its cost, whenever it is done. So it is only done in the end, or where
/// a track has no child to miss with; and whether a plot starts a track or is a false alarm need
/// not be decided when it comes. Deciding both early would fill the k places with copies. A
/// hypothesis is ranked by what its tracks cost so far; of tracks that do not pay yet, a tenth
/// counts.
///
/// That ranking looks at no later scan. Where a cluster has many tracks, above all many that have
/// just begun and whose plots could be paired in many ways, k hypotheses are few, and good tracks
/// are lost, since they cost first and gain with their later plots. `look_ahead` ranks a track by a
/// mean of that and of the cost of the best column that it may become, which has weight 1 / (R + 1)
/// with R scans to come: in full it would favour hypotheses whose tracks all count on the same
/// plots, and the more scans are to come, the more tracks may.
///
/// With all hypotheses kept, the answer is optimal. With one scan it always is.
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
