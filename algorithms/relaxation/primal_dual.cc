#include "algorithms/relaxation/primal_dual.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kIterationsPerLook = 32;

/// How far x and mu go along their slopes.
struct Steps {
  double x;
  double mu;
};

Steps steps_of(const NormalComponent& component, const PrimalDualOptions& options) {
  const double norm2 = squared_norm(component);
  if (options.alpha == 0.0) {
    const double both = options.step / std::sqrt(norm2);
    return {both, both};
  }
  return {options.step * 2.0 / options.alpha, options.step * options.alpha / norm2};
}

class PrimalDual {
 public:
  PrimalDual(const NormalComponent& component, const PrimalDualOptions& options)
      : component_(component),
        options_(options),
        dt_(steps_of(component, options)),
        x_(component.column.size(), 0.0),
        mu_(component.row.size(), 0.0),
        usage_(component.row.size()) {
    result_.bound = -std::numeric_limits<double>::infinity();
  }

  PrimalDualResult run(const Budget& budget) {
    note_bound();
    bool settled = false;
    bool expired = budget.expired();
    while (!settled && !expired && result_.iterations < options_.iterations) {
      double slope = 0.0;
      for (int i = 0; i < kIterationsPerLook; ++i) slope = advance();
      result_.iterations += kIterationsPerLook;
      note_bound();
      settled = options_.alpha > 0.0 ? slope < options_.tolerance : at_optimum();
      expired = budget.expired();
    }
    if (!settled) result_.stop = expired ? Stop::kDeadline : Stop::kIterationLimit;
    result_.x = std::move(x_);
    return std::move(result_);
  }

 private:
  /// Returns the largest change, relative to the step.
  double advance() {
    double change = 0.0;
    std::fill(usage_.begin(), usage_.end(), 0.0);
    for (int j = 0; j < component_.columns(); ++j) {
      const double before = x_[index(j)];
      const double slope = price(j) + options_.alpha * before;
      const double after = std::max(0.0, before - dt_.x * slope);
      x_[index(j)] = after;
      change = std::max(change, std::abs(after - before) / dt_.x);
      const double felt = options_.alpha > 0.0 ? before : 2.0 * after - before;
      for (const int r : component_.rows_of(j)) usage_[index(r)] += felt;
    }
    for (std::size_t r = 0; r < mu_.size(); ++r) {
      const double after = std::max(0.0, mu_[r] + dt_.mu * (usage_[r] - 1.0));
      change = std::max(change, std::abs(after - mu_[r]) / dt_.mu);
      mu_[r] = after;
    }
    return change;
  }

  /// c_j with the prices of its rows.
  [[nodiscard]] double price(int j) const {
    double price = component_.cost[index(j)];
    for (const int r : component_.rows_of(j)) price += mu_[index(r)];
    return price;
  }

  void note_bound() {
    double bound = 0.0;
    for (const double mu : mu_) bound -= mu;
    for (int j = 0; j < component_.columns(); ++j) bound += std::min(0.0, price(j));
    if (bound <= result_.bound) return;
    result_.bound = bound;
    result_.multiplier = mu_;
  }

  [[nodiscard]] bool at_optimum() {
    double cost = 0.0;
    std::fill(usage_.begin(), usage_.end(), 0.0);
    for (int j = 0; j < component_.columns(); ++j) {
      cost += component_.cost[index(j)] * x_[index(j)];
      for (const int r : component_.rows_of(j)) usage_[index(r)] += x_[index(j)];
    }
    const double fullest = *std::max_element(usage_.begin(), usage_.end());
    return fullest <= 1.0 + options_.tolerance &&
           cost - result_.bound <= options_.tolerance * std::max(1.0, std::abs(cost));
  }

  const NormalComponent& component_;
  PrimalDualOptions options_;
  Steps dt_;
  std::vector<double> x_;
  std::vector<double> mu_;
  std::vector<double> usage_;
  PrimalDualResult result_;
};

}  // namespace

double squared_norm(const NormalComponent& component) {
  constexpr int kMostIterations = 100;
  constexpr double kClose = 1.01;
  std::vector<double> v(component.row.size(), 1.0);
  double largest = 0.0;
  for (int i = 0; i < kMostIterations; ++i) {
    std::vector<double> next(v.size(), 0.0);
    for (int j = 0; j < component.columns(); ++j) {
      double sum = 0.0;
      for (const int r : component.rows_of(j)) sum += v[index(r)];
      for (const int r : component.rows_of(j)) next[index(r)] += sum;
    }
    largest = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < v.size(); ++r) {
      largest = std::max(largest, next[r] / v[r]);
      least = std::min(least, next[r] / v[r]);
    }
    if (largest <= kClose * least) break;
    for (std::size_t r = 0; r < v.size(); ++r) v[r] = next[r] / largest;
  }
  return largest;
}

PrimalDualResult primal_dual(const NormalComponent& component, const PrimalDualOptions& options,
                             const Budget& budget) {
  return PrimalDual(component, options).run(budget);
}

}  // namespace mda
