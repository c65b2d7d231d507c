#include "algorithms/api/one_scan.h"

#include <limits>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace

Verdict takes_one_scan(const Shape& shape) {
  if (shape.dimensions <= 2) return {};
  return {false, "takes one scan with fixed tracks, or two without: more than two dimensions"};
}

std::vector<Rest> rests_of(const AssociationProblem& problem) {
  std::vector<Rest> rests(index(problem.rows()));
  for (int r = 0; r < problem.rows(); ++r) {
    if (problem.use(r) != RowUse::kExactlyOnce) continue;
    rests[index(r)].cost = std::numeric_limits<double>::infinity();
  }
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    if (rows.size() > 1) continue;
    Rest& rest = rests[index(rows.front())];
    if (problem.cost(j) < rest.cost) rest = {problem.cost(j), j};
  }
  return rests;
}

}  // namespace mda
