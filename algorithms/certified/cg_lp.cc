#include "algorithms/certified/cg_lp.h"

#include <algorithm>
#include <utility>

#include "algorithms/certified/ascent.h"
#include "algorithms/certified/column_generation.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// x of the window: the columns of the packing, and what they leave of the exactly-once rows.
std::vector<double> point_of(const AssociationProblem& problem, const WindowPacking& window,
                             const LpPoint& point) {
  std::vector<double> x(index(problem.columns()), 0.0);
  std::vector<double> free(index(problem.rows()), 1.0);
  for (const auto& [column, value] : point.x) {
    const int j = window.packing.origin[index(column)];
    x[index(j)] = std::min(1.0, value);
    for (const int r : problem.rows_of(j)) free[index(r)] -= value;
  }
  for (int r = 0; r < problem.rows(); ++r) {
    const int alone = window.column_of_charge[index(r)];
    if (alone >= 0) x[index(alone)] = std::clamp(free[index(r)], 0.0, 1.0);
  }
  return x;
}

class CgLp final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kRelaxation, .exact = true, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    Solution solution;
    solution.answer = Answer::kRelaxation;
    const WindowPacking window = pack(problem);
    AscentResult ascent = ascent_.run(window.packing, budget);
    LpPoint point = solve_by_columns(window.packing, std::move(ascent.prices), budget);
    Pricing pricing;
    fold_into_roots(window.packing, point.prices, pricing);
    solution.row_dual = window.row_dual(point.prices);
    solution.lower_bound = window.bound_nats(pricing.bound);
    solution.stats.iterations = point.iterations;
    if (point.outcome == Outcome::kDeadline || budget.expired()) {
      solution.stop = Stop::kDeadline;
      return solution;
    }
    const double unrounded = window.nats(pricing.bound + window.charged);
    const bool is_fine = unrounded - solution.lower_bound <= cost_tolerance(unrounded);
    solution.status = is_fine ? Status::kOptimal : Status::kFeasible;
    solution.x = point_of(problem, window, point);
    return solution;
  }

 private:
  DualAscent ascent_;
};

}  // namespace

std::unique_ptr<Associator> make_cg_lp() { return std::make_unique<CgLp>(); }

}  // namespace mda
