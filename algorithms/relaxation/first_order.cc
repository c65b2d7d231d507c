#include "algorithms/relaxation/first_order.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/relaxation/greedy_rounding.h"
#include "algorithms/relaxation/normal_form.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Cost and bound agree when they differ by less, relative to the cost and at least to 1 nat.
constexpr double kClosed = 1e-9;

/// The columns of the component, by the problem's numbers, that rounding chooses.
std::vector<int> rounded(const NormalComponent& component, std::vector<double> x) {
  ProblemBuilder builder;
  for (const int level : component.row_level) builder.add_row(level, RowUse::kAtMostOnce);
  for (int j = 0; j < component.columns(); ++j) {
    builder.add_column(component.cost[index(j)], component.rows_of(j));
  }
  for (double& value : x) value = std::min(value, 1.0);
  std::vector<int> chosen = greedy_rounding(builder.build(), x);
  for (int& j : chosen) j = component.column[index(j)];
  return chosen;
}

class FirstOrder final : public Associator {
 public:
  explicit FirstOrder(const PrimalDualOptions& options) : options_(options) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const NormalForm form = normal_form(problem);
    std::vector<int> chosen;
    std::vector<double> multiplier(index(problem.rows()), 0.0);
    Stop stop = budget.expired() ? Stop::kDeadline : Stop::kFinished;
    std::int64_t iterations = 0;
    for (const NormalComponent& component : form.components) {
      PrimalDualResult part = primal_dual(component, options_, budget);
      for (int r = 0; r < component.rows(); ++r) {
        multiplier[index(component.row[index(r)])] = part.multiplier[index(r)];
      }
      const std::vector<int> columns = rounded(component, std::move(part.x));
      chosen.insert(chosen.end(), columns.begin(), columns.end());
      if (part.stop != Stop::kFinished && stop != Stop::kDeadline) stop = part.stop;
      iterations += part.iterations;
    }
    Solution solution = selection_of(form.completed(problem, std::move(chosen)), problem.columns(),
                                     Status::kFeasible);
    solution.row_dual = form.row_dual(multiplier);
    solution.lower_bound = lagrangian_bound(problem, solution.row_dual);
    if (stop != Stop::kDeadline && closed(problem, solution)) solution.status = Status::kOptimal;
    solution.stop = stop;
    solution.stats.iterations = iterations;
    return solution;
  }

 private:
  static bool closed(const AssociationProblem& problem, const Solution& solution) {
    double cost = 0.0;
    for (int j = 0; j < problem.columns(); ++j) cost += problem.cost(j) * solution.x[index(j)];
    return cost - solution.lower_bound <= kClosed * std::max(1.0, std::abs(cost));
  }

  PrimalDualOptions options_;
};

}  // namespace

std::unique_ptr<Associator> make_first_order(const PrimalDualOptions& options) {
  return std::make_unique<FirstOrder>(options);
}

std::unique_ptr<Associator> make_mapada_window() {
  return make_first_order({.alpha = 0.02, .step = 0.9, .tolerance = 1e-3});
}

std::unique_ptr<Associator> make_pdhg() {
  return make_first_order({.step = 0.99, .tolerance = 1e-6, .iterations = 100000});
}

}  // namespace mda
