#include "harness/scan_values.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "algorithms/catalog.h"
#include "harness/referee.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

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

std::vector<double> values_to_follow(const AssociationProblem& problem, const Solution& solution,
                                     TrackUpdate update) {
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
  Solution decision = decided(problem, solution.x);
  if (decision.x.empty()) throw std::runtime_error("the marginals allow no choice");
  return std::move(decision.x);
}

}  // namespace mda
