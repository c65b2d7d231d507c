#include "harness/scan_values.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "harness/referee.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// With the same rows and columns, at other costs.
AssociationProblem recosted(const AssociationProblem& problem, std::span<const double> costs) {
  ProblemBuilder builder;
  for (int r = 0; r < problem.rows(); ++r) builder.add_row(problem.dimension(r), problem.use(r));
  for (int j = 0; j < problem.columns(); ++j) {
    builder.add_column(costs[index(j)], problem.rows_of(j));
  }
  builder.set_dimensions(problem.shape().dimensions);
  return builder.build();
}

bool is_whole(std::span<const double> x) {
  return std::ranges::all_of(
      x, [](double v) { return std::min(std::abs(v), std::abs(1.0 - v)) <= kIntegralTolerance; });
}

}  // namespace

std::vector<int> largest_by_track(const AssociationProblem& problem, std::span<const double> x) {
  const PairView& pairs = *problem.views()->pairs;
  std::vector<int> largest(index(pairs.tracks()), kNoColumn);
  for (int j = 0; j < problem.columns(); ++j) {
    const int row = problem.rows_of(j)[0];
    if (problem.dimension(row) != 0) continue;
    int& best = largest[index(row)];
    if (best == kNoColumn || x[index(j)] > x[index(best)]) best = j;
  }
  return largest;
}

bool are_in_conflict(const AssociationProblem& problem, std::span<const int> columns) {
  std::set<int> used;
  return std::ranges::any_of(columns, [&](int column) {
    if (column == kNoColumn) return false;
    const auto rows = problem.rows_of(column);
    return rows.size() > 1 && !used.insert(rows.back()).second;
  });
}

std::vector<double> most_probable_choice(const AssociationProblem& problem,
                                         std::span<const double> marginals, Associator& solver) {
  constexpr double kLeast = 1e-12;
  std::vector<double> costs;
  for (const double marginal : marginals) costs.push_back(-std::log(std::max(marginal, kLeast)));
  Solution choice = solver.solve(recosted(problem, costs), Budget{});
  if (choice.x.size() != marginals.size()) {
    throw std::runtime_error("the marginals' most probable choice was not found");
  }
  return std::move(choice.x);
}

std::vector<double> values_to_follow(const AssociationProblem& problem, const Solution& solution,
                                     TrackUpdate update, Associator& solver) {
  switch (solution.answer) {
    case Answer::kSelection:
      return solution.x;
    case Answer::kRelaxation: {
      std::vector<double> x(solution.x.size(), 0.0);
      for (const int column : largest_by_track(problem, solution.x)) {
        if (column != kNoColumn) x[index(column)] = 1.0;
      }
      return x;
    }
    case Answer::kMarginals:
      break;
  }
  if (update == TrackUpdate::kSoft || is_whole(solution.x)) return solution.x;
  return most_probable_choice(problem, solution.x, solver);
}

}  // namespace mda
