// The LP relaxation of a packing by column generation.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/backends/run.h"
#include "algorithms/certified/pricing.h"

namespace mda {

struct LpPoint {
  /// kDeadline: prices and bound hold, but are not those of the LP's optimum, and there is no x.
  Outcome outcome = Outcome::kDeadline;
  std::vector<std::pair<int, double>> x;  ///< columns above 0, ascending: a basic optimum
  std::vector<Steps> prices;              ///< the best found, one per row
  Steps bound = 0;                        ///< what they prove
  int rounds = 0;                         ///< of pricing
  std::int64_t iterations = 0;            ///< of the simplex method
};

/// The columns of an LP point, the largest value first.
[[nodiscard]] std::vector<int> columns_by_value(std::vector<std::pair<int, double>> x);

/// Costs and prices of linear programmes are in units of so many steps: the largest is about 1,000.
inline constexpr double kStepsPerLpUnit = 17179869184.0;

/// A restricted master problem (Clp) of some columns of every row, the cheapest by `prices`, grows
/// by columns of negative reduced cost, a few per tree and round, until there is none. Every round
/// prices all columns, so each proves a bound. The bound never falls below that of `prices`. Small
/// packings start with all their columns.
/// Source: column generation for set packing over tracks, as Wang, Wolf, Fowlkes and Yarkony 2017;
/// the trees are explicit here, so pricing is one pass over the columns.
[[nodiscard]] LpPoint solve_by_columns(const Packing& packing, std::vector<Steps> prices,
                                       const Budget& budget);

}  // namespace mda
