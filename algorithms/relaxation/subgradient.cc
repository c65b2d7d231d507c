#include "algorithms/relaxation/subgradient.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "algorithms/relaxation/staged_assignment.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Cost and bound agree when they differ by less, in the component's unit (the largest cost is
/// between a half and one).
constexpr double kClosed = 1e-10;

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

class Ascent {
 public:
  Ascent(const NormalComponent& component, const SubgradientOptions& options)
      : component_(component),
        options_(options),
        stages_(component),
        u_(component.row.size(), 0.0),
        direction_(component.row.size(), 0.0),
        share_(options.step),
        by_cost_(component.column.size()) {
    result_.bound = -std::numeric_limits<double>::infinity();
    std::iota(by_cost_.begin(), by_cost_.end(), 0);
    std::stable_sort(by_cost_.begin(), by_cost_.end(), [&](int a, int b) {
      return component.cost[index(a)] < component.cost[index(b)];
    });
  }

  SubgradientResult run(const Budget& budget) {
    while (result_.iterations < options_.iterations && share_ >= options_.least_step) {
      const RelaxedOptimum& relaxed = stages_.relax(u_);
      ++result_.iterations;
      note_bound(relaxed);
      note_choices(relaxed);
      result_.closed = result_.cost - result_.bound <= kClosed * std::max(1.0, -result_.cost);
      if (result_.closed) break;
      if (budget.expired()) {
        result_.expired = true;
        break;
      }
      if (!step(relaxed)) break;
    }
    return std::move(result_);
  }

 private:
  void note_bound(const RelaxedOptimum& relaxed) {
    if (relaxed.bound > result_.bound) {
      since_better_ = 0;
      result_.bound = relaxed.bound;
      result_.multiplier = relaxed.multiplier;
    } else if (++since_better_ >= options_.patience) {
      since_better_ = 0;
      share_ /= 2.0;
    }
  }

  void note_choices(const RelaxedOptimum& relaxed) {
    const bool holds = std::all_of(relaxed.usage.begin(), relaxed.usage.end(),
                                   [](int usage) { return usage <= 1; });
    if (holds) note_choice(relaxed.columns);
    note_choice(filled_up(stages_.recover(u_)));
  }

  /// With the cheapest of the columns whose rows are still free, one after the other.
  [[nodiscard]] std::vector<int> filled_up(std::vector<int> columns) const {
    std::vector<char> used(u_.size(), 0);
    const auto take = [&](int j) {
      for (const int r : component_.rows_of(j)) used[index(r)] = 1;
    };
    for (const int j : columns) take(j);
    for (const int j : by_cost_) {
      const auto rows = component_.rows_of(j);
      if (std::any_of(rows.begin(), rows.end(), [&](int r) { return used[index(r)] != 0; })) {
        continue;
      }
      take(j);
      columns.push_back(j);
    }
    return columns;
  }

  void note_choice(std::vector<int> columns) {
    double cost = 0.0;
    for (const int j : columns) cost += component_.cost[index(j)];
    if (cost >= result_.cost) return;
    result_.cost = cost;
    result_.columns = std::move(columns);
  }

  /// False when there is no way up.
  bool step(const RelaxedOptimum& relaxed) {
    std::vector<double> gradient(u_.size(), 0.0);
    for (std::size_t r = 0; r < u_.size(); ++r) {
      if (component_.row_level[r] < 2) continue;
      gradient[r] = relaxed.usage[r] - 1;
      if (u_[r] == 0.0) gradient[r] = std::max(0.0, gradient[r]);
    }
    const double against = dot(gradient, direction_);
    const double deflection = against < 0.0 ? -1.5 * against / dot(direction_, direction_) : 0.0;
    for (std::size_t r = 0; r < u_.size(); ++r) {
      direction_[r] = gradient[r] + deflection * direction_[r];
      if (u_[r] == 0.0) direction_[r] = std::max(0.0, direction_[r]);
    }
    const double length2 = dot(direction_, direction_);
    if (length2 == 0.0) return false;
    const double length = share_ * (result_.cost - relaxed.bound) / length2;
    for (std::size_t r = 0; r < u_.size(); ++r) {
      u_[r] = std::max(0.0, u_[r] + length * direction_[r]);
    }
    return true;
  }

  const NormalComponent& component_;
  SubgradientOptions options_;
  StagedAssignment stages_;
  std::vector<double> u_;
  std::vector<double> direction_;
  double share_;
  std::vector<int> by_cost_;
  int since_better_ = 0;
  SubgradientResult result_;
};

}  // namespace

SubgradientResult maximise_dual(const NormalComponent& component, const SubgradientOptions& options,
                                const Budget& budget) {
  return Ascent(component, options).run(budget);
}

}  // namespace mda
