#include "algorithms/relaxation/lagrangian_sd.h"

#include <algorithm>
#include <vector>

#include "algorithms/relaxation/normal_form.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// What the multipliers u prove: -sum_r u_r + sum_j min(0, c_j + sum_{r in j} u_r).
double lagrangian_bound(const AssociationProblem& problem, const std::vector<double>& u) {
  double bound = 0.0;
  for (const double value : u) bound -= value;
  for (int j = 0; j < problem.columns(); ++j) {
    double price = problem.cost(j);
    for (const int r : problem.rows_of(j)) price += u[index(r)];
    bound += std::min(0.0, price);
  }
  return bound;
}

/// The columns that fill the exactly-once rows which `chosen` leaves free.
std::vector<int> completed(const AssociationProblem& problem, const NormalForm& form,
                           std::vector<int> chosen) {
  std::vector<char> used(index(problem.rows()), 0);
  for (const int j : chosen) {
    for (const int r : problem.rows_of(j)) used[index(r)] = 1;
  }
  for (int r = 0; r < problem.rows(); ++r) {
    if (used[index(r)] == 0 && form.column_of_charge[index(r)] != kNoColumn) {
      chosen.push_back(form.column_of_charge[index(r)]);
    }
  }
  return chosen;
}

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
    Solution solution = selection_of(completed(problem, form, std::move(chosen)), problem.columns(),
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
