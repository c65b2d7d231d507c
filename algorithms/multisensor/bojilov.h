// Three sensors by two assignments in sequence.
#pragma once

#include <memory>
#include <optional>

#include "algorithms/api/associator.h"

namespace mda {

/// What step 4 does with a triple that is not feasible.
enum class InfeasibleTriple {
  kDrop,     ///< excludes it whole, as printed
  kKeepPair  ///< takes the third sensor's report out of it: the pair of step 2 stays
};

/// Where step 3 puts a report of the third sensor that fits nowhere. Treated, all places cost the
/// same, and the paper leaves it open; step 4 may then exclude a good pair with it.
enum class Misfits {
  kToSingles,  ///< to a single report if there is one, else to the pair of the greatest distance
  kToPairs     ///< the other way round: the most harm that the printed steps may do
};

/// All in the units of SensorView::distance; infinity is no threshold.
struct BojilovOptions {
  double q = 0.0;   ///< Q > 0: pairs farther apart are not feasible
  double q3 = 0.0;  ///< the same for the cost of a triple; Q as printed
  /// Q*, not below Q: what a term that is not feasible costs in step 1; nothing: no treatment.
  std::optional<double> q_star = std::nullopt;
  /// The same in step 3, not below Q and Q3; Q* as printed.
  std::optional<double> q3_star = std::nullopt;
  InfeasibleTriple infeasible = InfeasibleTriple::kDrop;
  Misfits misfits = Misfits::kToSingles;  ///< of treated costs
};

/// As printed, with the treatment of section 4: Q loses the share `loss` of true pairs, triples
/// have the same threshold, Q* is 10 / 9.21 of Q.
[[nodiscard]] BojilovOptions bojilov_options(double loss);

/// The same with Misfits::kToPairs.
[[nodiscard]] BojilovOptions worst_ties_options(double loss);

/// Without the treatment, the point `x` of figure 2: the terms beyond Q are still split and
/// excluded.
[[nodiscard]] BojilovOptions untreated_options(double loss);

/// Triples have a threshold that loses the same share of true triples as Q of true pairs, and what
/// is not feasible as a triple stays a pair. Not in the paper.
[[nodiscard]] BojilovOptions calibrated_options(double loss);

/// Without any threshold: the algorithm A3 that the paper extends, for P_D = 1 and no false alarms.
[[nodiscard]] BojilovOptions a3_options();

/// The sensors are sorted by their numbers of reports, most first. Step 1 assigns the reports of
/// the second to those of the first, all of them, by least total distance; step 2 splits the pairs
/// that are not feasible. Step 3 assigns the reports of the third, all of them, to the pairs and
/// single reports of steps 1 and 2; a pair costs the sum of both distances, and nothing if it gets
/// none. Step 4 excludes what is not feasible. With treatment, all terms that are not feasible have
/// one and the same cost in both assignments.
///
/// Works on distances alone; the tuples it returns are columns where there is such a column.
/// Deterministic. O(reports cubed), in practice near O(reports squared). Throws
/// std::invalid_argument for thresholds that are not above 0, or above their treated cost.
///
/// Source: Bojilov, "Data association algorithm for multisensor multitarget tracking" (1995),
/// equations 1 to 6 (with the factor of equation 1 inverted, so that A is chi-square), section 4.
[[nodiscard]] std::unique_ptr<Associator> make_bojilov(const BojilovOptions& options);

}  // namespace mda
