#include "algorithms/certified/part_solver.h"

#include <algorithm>
#include <utility>

#include "algorithms/certified/column_generation.h"
#include "algorithms/certified/enumeration.h"
#include "algorithms/certified/kernel_search.h"
#include "algorithms/certified/swap_search.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

constexpr int kMostColumnsToEnumerate = 250;
constexpr int kMostNodesBeforeLp = 1000;
constexpr int kMostNodesAfterLp = 3000;
constexpr int kKicks = 10;

}  // namespace

Settlement PartSolver::settle(std::vector<Part>& parts, Steps ceiling) {
  return settle(parts, ceiling, Stage::kAscent);
}

Settlement PartSolver::settle(std::vector<Part>& parts, Steps ceiling, Stage stage) {
  const std::size_t step = proof_.parts(parts);
  Steps rest = 0;  // the bounds of parts to come
  for (const Part& part : parts) rest += part.bound;
  Settlement all;
  all.choice.emplace();
  for (int p = 0; p < std::ssize(parts); ++p) {
    Part& part = parts[index(p)];
    rest -= part.bound;
    Settlement one;
    if (all.choice) {
      // The part may cost this less a grid step at most, or the whole reaches the ceiling.
      const Steps most = on_grid(ceiling - kGrid - all.floor - rest + 1);
      one = settle(part, most, stage);
      all.complete = all.complete && one.complete;
    } else {
      proof_.prices(part.packing, part.prices);
      proof_.enumerate();
      one.floor = all.complete ? on_grid(part.bound) : part.bound;
    }
    proof_.floor_of_part(step, p, one.floor);
    all.floor += one.floor;
    const std::vector<int>& piece = one.choice ? *one.choice : one.pieces;
    all.pieces.insert(all.pieces.end(), piece.begin(), piece.end());
    all.cost += one.cost;
    if (!one.choice) all.choice.reset();
  }
  if (all.choice) all.choice = all.pieces;
  if (all.complete && !all.choice) all.floor = ceiling;
  return all;
}

Settlement PartSolver::settle(Part& part, Steps ceiling, Stage stage) {
  if (part.choice) return by_bound(part, ceiling);
  if (auto settled = try_all(part, ceiling, stage)) return *std::move(settled);
  return stage == Stage::kAscent ? by_lp(part, ceiling) : by_search(part, ceiling);
}

Settlement PartSolver::by_bound(Part& part, Steps ceiling) {
  proof_.prices(part.packing, part.prices);
  proof_.enumerate();
  Settlement settled;
  settled.floor = std::min(part.bound, ceiling);
  if (part.bound < ceiling) {
    settled.cost = part.bound;
    settled.choice = std::move(part.choice);
  }
  return settled;
}

std::optional<Settlement> PartSolver::try_all(const Part& part, Steps ceiling, Stage stage) {
  if (part.packing.columns() > kMostColumnsToEnumerate) return std::nullopt;
  Pricing pricing;
  price(part.packing, part.prices, pricing);
  const int most_nodes = stage == Stage::kAscent ? kMostNodesBeforeLp : kMostNodesAfterLp;
  const Enumeration found =
      enumerate(part.packing, part.prices, pricing, ceiling, most_nodes, budget_);
  work_.nodes += found.nodes;
  if (!found.complete) return std::nullopt;
  proof_.prices(part.packing, part.prices);
  proof_.enumerate();
  Settlement settled;
  settled.floor = ceiling;
  if (found.choice) {
    settled.cost = cost_of(part.packing, *found.choice);
    settled.floor = settled.cost;
    settled.choice = origins_of(part.packing, *found.choice);
  }
  return settled;
}

Settlement PartSolver::by_lp(Part& part, Steps ceiling) {
  Settlement settled;
  LpPoint point = solve_by_columns(part.packing, part.prices, budget_);
  work_.iterations += point.iterations;
  Pricing pricing;
  part.prices = std::move(point.prices);
  fold_into_roots(part.packing, part.prices, pricing);
  part.bound = pricing.bound;
  for (std::size_t r = 0; r < part.prices.size(); ++r) {
    lp_prices_.emplace_back(part.packing.row_origin[r], part.prices[r]);
  }
  if (point.outcome != Outcome::kOptimal) {
    settled.complete = false;
    settled.floor = std::min(ceiling, part.bound);
    return settled;
  }
  SwapSearch swaps(part.packing, part.prices, pricing, ceiling - pricing.bound);
  swaps.start(columns_by_value(std::move(point.x)));
  if (swaps.cost() - pricing.bound >= kGrid) swaps.improve(kKicks, budget_);
  if (swaps.cost() < ceiling) {
    ceiling = swaps.cost();
    settled.cost = ceiling;
    settled.choice = origins_of(part.packing, swaps.choice());
  }
  settled.floor = ceiling;
  proof_.prices(part.packing, part.prices);
  if (pricing.bound > ceiling - kGrid) {
    proof_.enumerate();
    return settled;
  }
  std::vector<Part> kernels =
      parts_beyond(part.packing, part.prices, pricing, ceiling, swaps.choice());
  Settlement better = settle(kernels, ceiling, Stage::kLp);
  settled.complete = better.complete;
  settled.floor = better.floor;
  settled.pieces = std::move(better.pieces);
  if (better.choice) {
    settled.cost = better.cost;
    settled.choice = std::move(better.choice);
  }
  return settled;
}

Settlement PartSolver::by_search(const Part& part, Steps ceiling) {
  SearchResult found = KernelSearch(part, ceiling, budget_, proof_).run();
  work_.nodes += found.nodes;
  work_.iterations += found.iterations;
  Settlement settled;
  settled.complete = found.complete;
  settled.floor = found.floor;
  if (found.choice) {
    settled.cost = cost_of(part.packing, *found.choice);
    settled.choice = origins_of(part.packing, *found.choice);
  }
  return settled;
}

}  // namespace mda
