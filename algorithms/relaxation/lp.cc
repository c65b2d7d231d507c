#include "algorithms/relaxation/lp.h"

#include "algorithms/backends/clp.h"

namespace mda {
namespace {

class Lp final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kRelaxation, .exact = true, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& /*shape*/) const override { return {}; }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const auto start = Clock::now();
    LpResult lp = relaxation_.solve(problem, budget);
    Solution solution;
    if (lp.outcome == Outcome::kOptimal) {
      solution.status = Status::kOptimal;
      solution.x = std::move(lp.x);
      solution.lower_bound = lp.lower_bound;
      solution.row_dual = std::move(lp.row_dual);
    } else {
      solution = no_answer(lp.outcome);
    }
    solution.answer = Answer::kRelaxation;
    solution.stats.iterations = lp.iterations;
    solution.stats.translate_ms = lp.translate_ms;
    solution.stats.lp_ms = milliseconds_since(start);
    return solution;
  }

 private:
  LpRelaxation relaxation_;
};

}  // namespace

std::unique_ptr<Associator> make_lp() { return std::make_unique<Lp>(); }

}  // namespace mda
