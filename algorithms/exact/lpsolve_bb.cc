#include "algorithms/exact/lpsolve_bb.h"

#include <vector>

#include "algorithms/backends/lpsolve.h"

namespace mda {
namespace {

std::vector<int> used_columns(const std::vector<double>& x) {
  std::vector<int> columns;
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (x[j] > 0.5) columns.push_back(static_cast<int>(j));
  }
  return columns;
}

class LpSolveBranchAndBound final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .exact = true, .bounds = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& /*shape*/) const override { return {}; }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const LpSolveResult result = lpsolve(problem, true, budget);
    const bool optimal = result.outcome == Outcome::kOptimal;
    Solution solution = no_answer(result.outcome);
    if (optimal || !result.x.empty()) {
      const Stop stop = solution.stop;
      solution = selection_of(used_columns(result.x), problem.columns(),
                              optimal ? Status::kOptimal : Status::kFeasible);
      solution.stop = stop;
    }
    if (optimal) solution.lower_bound = result.objective;
    solution.stats.nodes = result.nodes;
    solution.stats.iterations = result.iterations;
    solution.stats.translate_ms = result.translate_ms;
    return solution;
  }
};

}  // namespace

std::unique_ptr<Associator> make_lpsolve_bb() { return std::make_unique<LpSolveBranchAndBound>(); }

}  // namespace mda
