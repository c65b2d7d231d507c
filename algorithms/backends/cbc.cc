#include "algorithms/backends/cbc.h"

#include <ClpSimplex.hpp>
#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "algorithms/backends/cbc_search.h"
#include "algorithms/backends/clp_deadline.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Solves the relaxation at the root. Returns whether it stayed within the budget.
bool solve_root(ClpSimplex& root, const Budget& budget) {
  bool stopped = false;
  const ClpDeadline handler(budget, stopped);
  root.passInEventHandler(&handler);
  root.primal();
  const ClpEventHandler none;
  root.passInEventHandler(&none);
  return !stopped;
}

/// Throws unless every row of the part is used as often as it may be.
void check_rows(const AssociationProblem& problem, std::span<const int> columns,
                const std::vector<int>& chosen) {
  std::vector<int> uses(index(problem.rows()), 0);
  for (const int j : chosen) {
    for (const int r : problem.rows_of(j)) ++uses[index(r)];
  }
  for (const int j : columns) {
    for (const int r : problem.rows_of(j)) {
      const bool broken =
          uses[index(r)] > 1 || (uses[index(r)] == 0 && problem.use(r) == RowUse::kExactlyOnce);
      if (broken) {
        throw std::runtime_error("CBC's answer uses row " + std::to_string(r) + " " +
                                 std::to_string(uses[index(r)]) + " times");
      }
    }
  }
}

}  // namespace

Solution solution_of(const CbcResult& result, int column_count) {
  Solution solution = no_answer(result.outcome);
  if (result.has_choice) {
    const Stop stop = solution.stop;
    solution =
        selection_of(result.chosen, column_count,
                     result.outcome == Outcome::kOptimal ? Status::kOptimal : Status::kFeasible);
    solution.stop = stop;
  }
  if (result.outcome != Outcome::kInfeasible) solution.lower_bound = result.lower_bound;
  solution.stats.nodes = result.nodes;
  solution.stats.iterations = result.iterations;
  solution.stats.translate_ms = result.translate_ms;
  return solution;
}

void CbcSolver::gather(const AssociationProblem& problem, std::span<const int> columns) {
  begins_.assign(1, 0);
  rows_.clear();
  costs_.clear();
  row_lower_.clear();
  number_of_row_.assign(index(problem.rows()), -1);
  for (const int j : columns) {
    for (const int r : problem.rows_of(j)) {
      int& number = number_of_row_[index(r)];
      if (number < 0) {
        number = static_cast<int>(row_lower_.size());
        row_lower_.push_back(problem.use(r) == RowUse::kExactlyOnce ? 1.0 : -COIN_DBL_MAX);
      }
      rows_.push_back(number);
    }
    begins_.push_back(static_cast<int>(rows_.size()));
    costs_.push_back(problem.cost(j));
  }
  ones_.resize(std::max({rows_.size(), row_lower_.size(), ones_.size()}), 1.0);
}

void CbcSolver::load(ClpSimplex& root) const {
  const int column_count = static_cast<int>(costs_.size());
  const int row_count = static_cast<int>(row_lower_.size());
  root.setLogLevel(0);
  // Upper bounds of 1 (the relaxation alone does without): CBC wants every variable bounded.
  root.loadProblem(column_count, row_count, begins_.data(), rows_.data(), ones_.data(), nullptr,
                   ones_.data(), costs_.data(), row_lower_.data(), ones_.data());
  for (int i = 0; i < column_count; ++i) root.setInteger(i);
}

CbcResult CbcSolver::solve_part(const AssociationProblem& problem, std::span<const int> columns,
                                const Budget& budget) {
  CbcResult result;
  if (budget.expired()) return result;
  if (columns.empty()) {
    result.outcome = Outcome::kOptimal;
    result.has_choice = true;
    result.lower_bound = 0.0;
    return result;
  }

  const auto start = Clock::now();
  gather(problem, columns);
  ClpSimplex root;
  load(root);
  result.translate_ms = milliseconds_since(start);
  if (!solve_root(root, budget)) return result;

  const CbcSearch search = search_from(root, budget);
  result.nodes = search.nodes;
  result.iterations = root.numberIterations() + search.iterations;
  result.outcome = search.outcome;
  result.lower_bound = search.lower_bound;
  if (search.best.empty()) return result;
  result.has_choice = true;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (search.best[i] > 0.5) result.chosen.push_back(columns[i]);
  }
  check_rows(problem, columns, result.chosen);
  return result;
}

CbcResult CbcSolver::solve(const AssociationProblem& problem, const Budget& budget) {
  CbcResult nothing;
  if (budget.expired()) return nothing;
  std::vector<char> touched(index(problem.rows()), 0);
  for (const int r : problem.row_indices()) touched[index(r)] = 1;
  for (int r = 0; r < problem.rows(); ++r) {
    if (problem.use(r) == RowUse::kExactlyOnce && touched[index(r)] == 0) {
      nothing.outcome = Outcome::kInfeasible;
      return nothing;
    }
  }
  std::vector<int> columns(index(problem.columns()));
  std::iota(columns.begin(), columns.end(), 0);
  return solve_part(problem, columns, budget);
}

}  // namespace mda
