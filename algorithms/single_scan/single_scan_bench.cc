// One scan of n tracks and m plots that share one cluster: the relaxations beside the exact
// assignment. Counter `iterations`: mean per scan.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/bench_main.h"
#include "algorithms/testing/random_pair_scans.h"

namespace mda {
namespace {

/// Several scans per size, so that no single lucky one is measured.
std::vector<AssociationProblem> scans(const benchmark::State& state) {
  constexpr std::uint64_t kScans = 32;
  testing::PairScanShape shape;
  shape.tracks = static_cast<int>(state.range(0));
  shape.plots = static_cast<int>(state.range(1));
  shape.side_km = 0.4;
  std::vector<AssociationProblem> problems;
  problems.reserve(kScans);
  for (std::uint64_t seed = 1; seed <= kScans; ++seed) {
    problems.push_back(testing::random_pair_scan(shape, seed));
  }
  return problems;
}

void solve(benchmark::State& state, const char* name) {
  const std::vector<AssociationProblem> problems = scans(state);
  const std::unique_ptr<Associator> algorithm = find_algorithm(name)->make();
  std::size_t next = 0;
  double iterations = 0.0;
  while (state.KeepRunning()) {
    const Solution solution = algorithm->solve(problems[next], Budget{});
    iterations += static_cast<double>(solution.stats.iterations.value_or(0));
    next = (next + 1) % problems.size();
  }
  state.counters["iterations"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"n", "m"})->Unit(benchmark::kMicrosecond);
  benchmark->Args({2, 3})->Args({4, 5})->Args({10, 12})->Args({30, 30});
}

BENCHMARK_CAPTURE(solve, gnn, "gnn")->Apply(sizes);
BENCHMARK_CAPTURE(solve, mapada, "mapada")->Apply(sizes);
BENCHMARK_CAPTURE(solve, mapada_miss, "mapada-miss")->Apply(sizes);
BENCHMARK_CAPTURE(solve, hnpda, "hnpda")->Apply(sizes);

}  // namespace
}  // namespace mda

int main(int argc, char** argv) { return mda::testing::bench_main(argc, argv); }
