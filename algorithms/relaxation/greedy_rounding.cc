#include "algorithms/relaxation/greedy_rounding.h"

#include <algorithm>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// The names follow the paper: R is the set of columns that are not decided yet, z* the one chosen
/// next, I(z*) the columns that share a row with it. R is not stored: a column leaves it when one
/// of its rows is used.
class GreedyRounding {
 public:
  GreedyRounding(const AssociationProblem& problem, std::span<const double> x)
      : problem_(problem), x_(x), row_used_(index(problem.rows()), 0) {}

  std::vector<int> run() {
    // At a feasible point columns at 1 share no row, so their order is free; those that are left
    // at the end are all tied at 0.
    choose_in_order_of_cost(free_columns(1.0 - kRoundingTie));
    choose_fractional();
    choose_in_order_of_cost(free_columns(0.0));
    std::sort(chosen_.begin(), chosen_.end());
    return std::move(chosen_);
  }

 private:
  [[nodiscard]] double x(int z) const { return x_[index(z)]; }

  [[nodiscard]] bool in_r(int z) const {
    const auto rows = problem_.rows_of(z);
    return worth_choosing(z) &&
           std::none_of(rows.begin(), rows.end(), [&](int r) { return row_used_[index(r)] != 0; });
  }

  [[nodiscard]] bool worth_choosing(int z) const {
    const auto rows = problem_.rows_of(z);
    return problem_.cost(z) < 0.0 || std::any_of(rows.begin(), rows.end(), [&](int r) {
             return problem_.use(r) == RowUse::kExactlyOnce;
           });
  }

  [[nodiscard]] bool cheaper(int z, int other) const {
    if (problem_.cost(z) != problem_.cost(other)) return problem_.cost(z) < problem_.cost(other);
    return z < other;
  }

  /// x_z* := 1, and I(z*) leaves R.
  void choose(int z_star) {
    chosen_.push_back(z_star);
    for (const int r : problem_.rows_of(z_star)) row_used_[index(r)] = 1;
  }

  /// The columns of R with at least this value.
  [[nodiscard]] std::vector<int> free_columns(double least) const {
    std::vector<int> r;
    for (int z = 0; z < problem_.columns(); ++z) {
      if (x_[index(z)] >= least && in_r(z)) r.push_back(z);
    }
    return r;
  }

  /// An LP optimum has few of them, so the largest is simply searched for in every step.
  void choose_fractional() {
    std::vector<int> r = free_columns(kRoundingTie);
    while (!r.empty()) {
      double largest = 0.0;
      for (const int z : r) largest = std::max(largest, x(z));
      int z_star = -1;
      for (const int z : r) {
        if (x(z) >= largest - kRoundingTie && (z_star < 0 || cheaper(z, z_star))) z_star = z;
      }
      choose(z_star);
      std::erase_if(r, [&](int z) { return !in_r(z); });
    }
  }

  void choose_in_order_of_cost(std::vector<int> r) {
    std::sort(r.begin(), r.end(), [&](int a, int b) { return cheaper(a, b); });
    for (const int z : r) {
      if (in_r(z)) choose(z);
    }
  }

  const AssociationProblem& problem_;
  std::span<const double> x_;
  std::vector<char> row_used_;
  std::vector<int> chosen_;
};

}  // namespace

std::vector<int> greedy_rounding(const AssociationProblem& problem, std::span<const double> x) {
  return GreedyRounding(problem, x).run();
}

}  // namespace mda
