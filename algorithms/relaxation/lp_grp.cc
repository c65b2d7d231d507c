#include "algorithms/relaxation/lp_grp.h"

#include <algorithm>

#include "algorithms/backends/clp.h"
#include "algorithms/relaxation/greedy_rounding.h"

namespace mda {
namespace {

class LpGrp final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const auto lp_start = Clock::now();
    LpResult lp = relaxation_.solve(problem, budget);
    const double lp_ms = milliseconds_since(lp_start);
    Solution solution = no_answer(lp.outcome);
    if (lp.outcome == Outcome::kOptimal) {
      const bool integral = std::all_of(lp.x.begin(), lp.x.end(), is_integral);
      const auto round_start = Clock::now();
      solution = selection_of(greedy_rounding(problem, lp.x), problem.columns(),
                              integral ? Status::kOptimal : Status::kFeasible);
      solution.stats.round_ms = milliseconds_since(round_start);
      solution.relaxation = std::move(lp.x);
      solution.lower_bound = lp.lower_bound;
      solution.row_dual = std::move(lp.row_dual);
    }
    solution.stats.iterations = lp.iterations;
    solution.stats.translate_ms = lp.translate_ms;
    solution.stats.lp_ms = lp_ms;
    return solution;
  }

 private:
  LpRelaxation relaxation_;
};

}  // namespace

std::unique_ptr<Associator> make_lp_grp() { return std::make_unique<LpGrp>(); }

}  // namespace mda
