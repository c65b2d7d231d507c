// Kernels on random problems of the size of typical windows: light (few targets, K = 3), medium
// (K = 7) and heavy (crowded sky, K = 3). The harness measures on real windows.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/relaxation/greedy_rounding.h"
#include "algorithms/testing/bench_main.h"
#include "algorithms/testing/random_problems.h"

namespace mda {
namespace {

testing::RandomShape window_shape(std::int64_t size) {
  testing::RandomShape shape;
  shape.dimensions = size == 1 ? 8 : 4;
  shape.rows_per_dimension = size == 0 ? 9 : 30;
  shape.columns = size == 0 ? 64 : size == 1 ? 340 : 970;
  shape.presence = size == 1 ? 0.5 : 0.8;
  shape.neighbourhood = 2;
  shape.positive_share = 0.0;
  return shape;
}

/// Several problems per size, so that no single lucky one is measured.
std::vector<AssociationProblem> windows(std::int64_t size) {
  constexpr std::uint64_t kWindows = 8;
  std::vector<AssociationProblem> problems;
  problems.reserve(kWindows);
  for (std::uint64_t seed = 1; seed <= kWindows; ++seed) {
    problems.push_back(testing::random_problem(window_shape(size), seed));
  }
  return problems;
}

void solve(benchmark::State& state, const char* name) {
  const std::vector<AssociationProblem> problems = windows(state.range(0));
  const std::unique_ptr<Associator> algorithm = find_algorithm(name)->make();
  std::size_t next = 0;
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(algorithm->solve(problems[next], Budget{}));
    next = (next + 1) % problems.size();
  }
}

void round_relaxation(benchmark::State& state) {
  const std::vector<AssociationProblem> problems = windows(state.range(0));
  const std::unique_ptr<Associator> lp = find_algorithm("lp")->make();
  std::vector<std::vector<double>> points;
  points.reserve(problems.size());
  for (const AssociationProblem& problem : problems) {
    points.push_back(lp->solve(problem, Budget{}).x);
  }
  std::size_t next = 0;
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(greedy_rounding(problems[next], points[next]));
    next = (next + 1) % problems.size();
  }
}

BENCHMARK_CAPTURE(solve, lp, "lp")->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, greedy, "greedy")->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, cbc, "cbc")->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, exact, "exact")->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(round_relaxation)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mda

int main(int argc, char** argv) { return mda::testing::bench_main(argc, argv); }
