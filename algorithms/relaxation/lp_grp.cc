#include "algorithms/relaxation/lp_grp.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "algorithms/backends/clp.h"
#include "algorithms/relaxation/greedy_rounding.h"
#ifdef MDA_WITH_LPSOLVE
#include "algorithms/backends/lpsolve.h"
#endif

namespace mda {
namespace {

/// Some way to a basic optimum of the relaxation.
using SolveRelaxation = std::function<LpResult(const AssociationProblem&, const Budget&)>;

/// `certifies`: the relaxation comes with row multipliers.
class LpGrp final : public Associator {
 public:
  LpGrp(SolveRelaxation solve_relaxation, bool certifies)
      : solve_relaxation_(std::move(solve_relaxation)), certifies_(certifies) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .bounds = true, .certifies = certifies_};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const auto lp_start = Clock::now();
    LpResult lp = solve_relaxation_(problem, budget);
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
  SolveRelaxation solve_relaxation_;
  bool certifies_;
};

}  // namespace

std::unique_ptr<Associator> make_lp_grp() {
  const auto clp = std::make_shared<LpRelaxation>();
  return std::make_unique<LpGrp>(
      [clp](const AssociationProblem& problem, const Budget& budget) {
        return clp->solve(problem, budget);
      },
      true);
}

#ifdef MDA_WITH_LPSOLVE
std::unique_ptr<Associator> make_lpsolve_lp_grp() {
  return std::make_unique<LpGrp>(
      [](const AssociationProblem& problem, const Budget& budget) {
        LibraryRun solved = lpsolve(problem, false, budget);
        LpResult result;
        result.outcome = solved.outcome;
        if (solved.outcome == Outcome::kOptimal) result.x = std::move(solved.x);
        result.lower_bound = solved.objective;
        result.iterations = solved.iterations;
        result.translate_ms = solved.translate_ms;
        return result;
      },
      false);
}
#endif

}  // namespace mda
