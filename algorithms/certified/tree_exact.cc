#include "algorithms/certified/tree_exact.h"

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <utility>

#include "algorithms/certified/ascent.h"
#include "algorithms/certified/part_solver.h"
#include "algorithms/certified/swap_search.h"

namespace mda {
namespace {

constexpr int kKicks = 4;

/// The best that is known of a window.
struct Knowledge {
  std::vector<int> choice;  ///< columns of the window
  Steps cost = 0;
  Steps bound = 0;
  std::vector<Steps> prices;  ///< folded into the roots
  bool complete = true;

  [[nodiscard]] bool closed() const { return cost - bound < kGrid; }
};

std::shared_ptr<const Certificate> certificate_of(const WindowPacking& window,
                                                  const Knowledge& known, Proof proof) {
  auto certificate = std::make_shared<Certificate>();
  certificate->bits = window.bits;
  certificate->cost = (known.cost + window.charged) / kGrid;
  certificate->steps = std::move(proof).steps();
  return certificate;
}

class TreeExact final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .exact = true, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const WindowPacking& window = packer_.pack(problem);
    Proof proof;
    PartSolver parts(budget, proof);
    const Knowledge known = solve(window.packing, budget, parts, proof);
    const bool proven = known.complete;
    const std::vector<int> choice = window.completed(problem, known.choice);
    const double bound = window.bound_nats(proven ? known.cost : known.bound);
    const Status status = proven ? status_of(problem, choice, bound) : Status::kFeasible;
    Solution solution = selection_of(choice, problem.columns(), status);
    if (!proven) solution.stop = Stop::kDeadline;
    if (proven && status != Status::kOptimal) {
      solution.note =
          "proven for costs rounded to 2^" + std::to_string(-window.bits) + " nats only";
    }
    solution.row_dual = window.row_dual(known.prices);
    solution.lower_bound = bound;
    solution.stats.iterations = parts.work().iterations;
    solution.stats.nodes = parts.work().nodes;
    if (proven) solution.certificate = certificate_of(window, known, std::move(proof));
    return solution;
  }

 private:
  Knowledge solve(const Packing& packing, const Budget& budget, PartSolver& solver, Proof& proof) {
    AscentResult ascent = ascent_.run(packing, budget);
    Knowledge known;
    known.prices = std::move(ascent.prices);
    Pricing pricing;
    fold_into_roots(packing, known.prices, pricing);
    known.bound = pricing.bound;
    std::vector<int> choice = std::move(ascent.choice);
    known.cost = ascent.cost;
    known.complete = !ascent.expired;
    if (known.complete && !known.closed()) {
      SwapSearch swaps(packing, known.prices, pricing, known.cost - known.bound);
      swaps.start(choice);
      swaps.improve(kKicks, budget);
      choice = swaps.choice();
      known.cost = swaps.cost();
    }
    known.choice = origins_of(packing, choice);
    proof.prices(packing, known.prices);
    if (known.closed()) {
      proof.enumerate();
    } else if (known.complete) {
      settle_parts(packing, pricing, choice, budget, solver, known);
    }
    return known;
  }

  static void settle_parts(const Packing& packing, const Pricing& pricing,
                           std::span<const int> choice, const Budget& budget, PartSolver& solver,
                           Knowledge& known) {
    std::vector<Part> parts = parts_beyond(packing, known.prices, pricing, known.cost, choice);
    Settlement settled = solver.settle(parts, known.cost);
    known.complete = settled.complete;
    known.bound = std::max(known.bound, settled.floor);
    if (settled.choice) {
      known.choice = *std::move(settled.choice);
      known.cost = settled.cost;
    } else if (!settled.complete) {
      put_together(packing, pricing, budget, std::move(settled.pieces), known);
    }
    if (!solver.lp_prices().empty()) take_lp_prices(packing, pricing.bound, solver, known);
  }

  /// They prove more than those of the ascent, unless columns that died by these mind them.
  static void take_lp_prices(const Packing& packing, Steps bound, const PartSolver& solver,
                             Knowledge& known) {
    std::unordered_map<int, int> row_of_origin;
    for (int r = 0; r < packing.rows(); ++r) {
      row_of_origin[packing.row_origin[static_cast<std::size_t>(r)]] = r;
    }
    std::vector<Steps> prices = known.prices;
    for (const auto& [origin, price] : solver.lp_prices()) {
      prices[static_cast<std::size_t>(row_of_origin.at(origin))] = price;
    }
    Pricing pricing;
    fold_into_roots(packing, prices, pricing);
    if (pricing.bound <= bound) return;
    known.prices = std::move(prices);
    known.bound = std::max(known.bound, pricing.bound);
  }

  /// What parts have found before the deadline, and of the choice known before what goes with it.
  static void put_together(const Packing& packing, const Pricing& pricing, const Budget& budget,
                           std::vector<int> pieces, Knowledge& known) {
    pieces.insert(pieces.end(), known.choice.begin(), known.choice.end());
    std::unordered_map<int, int> column_of_origin;
    for (int j = 0; j < packing.columns(); ++j) {
      column_of_origin[packing.origin[static_cast<std::size_t>(j)]] = j;
    }
    for (int& piece : pieces) piece = column_of_origin.at(piece);
    SwapSearch swaps(packing, known.prices, pricing, known.cost - pricing.bound);
    swaps.start(pieces);
    swaps.improve(0, budget);
    if (swaps.cost() >= known.cost) return;
    known.cost = swaps.cost();
    known.choice = origins_of(packing, swaps.choice());
  }

  Packer packer_;
  DualAscent ascent_;
};

}  // namespace

std::unique_ptr<Associator> make_tree_exact() { return std::make_unique<TreeExact>(); }

}  // namespace mda
