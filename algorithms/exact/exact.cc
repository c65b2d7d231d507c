#include "algorithms/exact/exact.h"

#include <algorithm>
#include <span>
#include <vector>

#include "algorithms/backends/cbc.h"
#include "algorithms/backends/clp.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// The columns of every component, ascending.
std::vector<std::vector<int>> columns_by_component(const AssociationProblem& problem) {
  std::vector<std::vector<int>> columns(index(problem.shape().components));
  for (int j = 0; j < problem.columns(); ++j) {
    columns[index(problem.component_of_column()[index(j)])].push_back(j);
  }
  return columns;
}

bool uses_exactly_once_row(const AssociationProblem& problem, std::span<const int> columns) {
  return std::any_of(columns.begin(), columns.end(), [&](int j) {
    const auto rows = problem.rows_of(j);
    return std::any_of(rows.begin(), rows.end(),
                       [&](int r) { return problem.use(r) == RowUse::kExactlyOnce; });
  });
}

enum class Windows { kAll, kKnownTracks };

class Exact final : public Associator {
 public:
  explicit Exact(Windows windows) : windows_(windows) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .exact = true, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    if (windows_ == Windows::kAll || shape.known_tracks) return {};
    return {false, "tracks are born in this window, and it is for known tracks"};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const auto start = Clock::now();
    LpResult lp = relaxation_.solve(problem, budget);
    const double lp_ms = milliseconds_since(start);
    CbcResult search;
    search.outcome = lp.outcome;
    if (lp.outcome == Outcome::kOptimal) search = solve_components(problem, lp.x, budget);
    search.iterations += lp.iterations;
    search.translate_ms += lp.translate_ms;

    Solution solution = solution_of(search, problem.columns());
    solution.relaxation = std::move(lp.x);
    solution.row_dual = std::move(lp.row_dual);
    solution.stats.lp_ms = lp_ms;
    return solution;
  }

 private:
  /// The results of all components, added up.
  CbcResult solve_components(const AssociationProblem& problem, const std::vector<double>& x,
                             const Budget& budget) {
    CbcResult all;
    all.outcome = Outcome::kOptimal;
    all.has_choice = true;
    all.lower_bound = 0.0;
    for (const auto& columns : columns_by_component(problem)) {
      add_component(problem, columns, x, budget, all);
      if (all.outcome == Outcome::kInfeasible) return all;
    }
    return all;
  }

  void add_component(const AssociationProblem& problem, std::span<const int> columns,
                     const std::vector<double>& x, const Budget& budget, CbcResult& all) {
    double lp_cost = 0.0;
    for (const int j : columns) lp_cost += problem.cost(j) * x[index(j)];
    const bool integral = std::all_of(columns.begin(), columns.end(),
                                      [&](int j) { return is_integral(x[index(j)]); });
    if (integral) {
      for (const int j : columns) {
        if (x[index(j)] > 0.5) all.chosen.push_back(j);
      }
      all.lower_bound += lp_cost;
      return;
    }
    const CbcResult part = branch_and_bound_.solve_part(problem, columns, budget);
    const bool may_stay_empty =
        part.outcome == Outcome::kDeadline && !uses_exactly_once_row(problem, columns);
    if (part.outcome != Outcome::kOptimal) all.outcome = part.outcome;
    all.has_choice = all.has_choice && (part.has_choice || may_stay_empty);
    all.chosen.insert(all.chosen.end(), part.chosen.begin(), part.chosen.end());
    all.lower_bound += std::max(lp_cost, part.lower_bound);
    all.nodes += part.nodes;
    all.iterations += part.iterations;
    all.translate_ms += part.translate_ms;
  }

  Windows windows_;
  LpRelaxation relaxation_;
  CbcSolver branch_and_bound_;
};

}  // namespace

std::unique_ptr<Associator> make_exact() { return std::make_unique<Exact>(Windows::kAll); }

std::unique_ptr<Associator> make_sd_exact() {
  return std::make_unique<Exact>(Windows::kKnownTracks);
}

}  // namespace mda
