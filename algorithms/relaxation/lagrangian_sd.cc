#include "algorithms/relaxation/lagrangian_sd.h"

#include <utility>
#include <vector>

#include "algorithms/relaxation/normal_form.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

class LagrangianSd final : public Associator {
 public:
  explicit LagrangianSd(const SubgradientOptions& options) : options_(options) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const NormalForm form = normal_form(problem);
    std::vector<int> chosen;
    std::vector<double> multiplier(index(problem.rows()), 0.0);
    bool closed = true;
    bool expired = budget.expired();
    int iterations = 0;
    for (const NormalComponent& component : form.components) {
      const SubgradientResult part = maximise_dual(component, options_, budget);
      for (const int j : part.columns) chosen.push_back(component.column[index(j)]);
      for (int r = 0; r < component.rows(); ++r) {
        multiplier[index(component.row[index(r)])] = part.multiplier[index(r)];
      }
      closed = closed && part.closed;
      expired = expired || part.expired;
      iterations += part.iterations;
    }
    Solution solution = selection_of(form.completed(problem, std::move(chosen)), problem.columns(),
                                     closed && !expired ? Status::kOptimal : Status::kFeasible);
    if (expired) solution.stop = Stop::kDeadline;
    solution.row_dual = form.row_dual(multiplier);
    solution.lower_bound = lagrangian_bound(problem, solution.row_dual);
    solution.stats.iterations = iterations;
    return solution;
  }

 private:
  SubgradientOptions options_;
};

}  // namespace

std::unique_ptr<Associator> make_lagrangian_sd(const SubgradientOptions& options) {
  return std::make_unique<LagrangianSd>(options);
}

std::unique_ptr<Associator> make_lagrangian_sd() { return make_lagrangian_sd({}); }

}  // namespace mda
