#include "algorithms/relaxation/lagrangian_sd.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "algorithms/relaxation/normal_form.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// A dense axial problem as one of at-most-once rows: with a reward for every column that exceeds
/// all costs, a choice is not optimal until it fills all rows. Every full choice has the same
/// number of columns, one per row of the first row's dimension.
struct AxialPacking {
  AssociationProblem problem;
  double reward = 0.0;  ///< nats
};

AxialPacking packing_of(const AssociationProblem& axial) {
  const auto [least, most] = std::ranges::minmax(axial.costs());
  AxialPacking packing;
  packing.reward = most + std::max(most - least, 0.5 * std::abs(most));
  if (packing.reward <= most) packing.reward = most + 1.0;  // all costs are 0
  ProblemBuilder builder;
  for (int r = 0; r < axial.rows(); ++r) builder.add_row(axial.dimension(r), RowUse::kAtMostOnce);
  for (int j = 0; j < axial.columns(); ++j) {
    builder.add_column(axial.cost(j) - packing.reward, axial.rows_of(j));
  }
  packing.problem = builder.build();
  return packing;
}

/// `x` with the cheapest columns that still fit, one after the other.
std::vector<double> filled_up(const AssociationProblem& axial, std::vector<double> x) {
  std::vector<char> used(index(axial.rows()), 0);
  const auto take = [&](int j) {
    x[index(j)] = 1.0;
    for (const int r : axial.rows_of(j)) used[index(r)] = 1;
  };
  for (int j = 0; j < axial.columns(); ++j) {
    if (x[index(j)] > 0.5) take(j);
  }
  std::vector<int> order(x.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int j) { return axial.cost(j); });
  for (const int j : order) {
    const auto rows = axial.rows_of(j);
    if (std::ranges::none_of(rows, [&](int r) { return used[index(r)] != 0; })) take(j);
  }
  return x;
}

class LagrangianSd final : public Associator {
 public:
  explicit LagrangianSd(const SubgradientOptions& options) : options_(options) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    return shape.is_axial ? Verdict{} : Associator::can_solve(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    if (!problem.shape().is_axial) return solve_feasible(problem, budget);
    const AxialPacking packing = packing_of(problem);
    Solution solution = solve_feasible(packing.problem, budget);
    solution.x = filled_up(problem, std::move(solution.x));
    for (int r = 0; r < problem.rows(); ++r) {
      if (problem.dimension(r) == problem.dimension(0)) {
        solution.row_dual[index(r)] -= packing.reward;
      }
    }
    solution.lower_bound = lagrangian_bound(problem, solution.row_dual);
    return solution;
  }

 private:
  Solution solve_feasible(const AssociationProblem& problem, const Budget& budget) const {
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

  SubgradientOptions options_;
};

}  // namespace

std::unique_ptr<Associator> make_lagrangian_sd(const SubgradientOptions& options) {
  return std::make_unique<LagrangianSd>(options);
}

std::unique_ptr<Associator> make_lagrangian_sd() { return make_lagrangian_sd({}); }

}  // namespace mda
