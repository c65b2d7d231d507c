#include "algorithms/exact/branch_and_bound.h"

#include "algorithms/backends/cbc.h"

namespace mda {
namespace {

class BranchAndBound final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .exact = true, .bounds = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& /*shape*/) const override { return {}; }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    return solution_of(solver_.solve(problem, budget), problem.columns());
  }

 private:
  CbcSolver solver_;
};

}  // namespace

std::unique_ptr<Associator> make_branch_and_bound() { return std::make_unique<BranchAndBound>(); }

}  // namespace mda
