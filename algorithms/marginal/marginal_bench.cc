// Marginals of single scans: fully connected ones, and 200 tracks on a strip or a square whose
// gates overlap more or less. The memory of the solver is warm.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>

#include "algorithms/catalog.h"
#include "algorithms/testing/bench_main.h"
#include "algorithms/testing/random_scans.h"

namespace mda {
namespace {

void solve(benchmark::State& state, const char* name, const AssociationProblem& problem) {
  const std::unique_ptr<Associator> algorithm = find_algorithm(name)->make();
  Solution solution = algorithm->solve(problem, Budget{});
  while (state.KeepRunning()) {
    solution = algorithm->solve(problem, Budget{});
    benchmark::DoNotOptimize(solution.x.data());
  }
  state.counters["columns"] = problem.columns();
  if (solution.x.empty()) state.SkipWithError(solution.note.c_str());
}

/// Every track wants every plot.
void dense(benchmark::State& state, const char* name) {
  testing::ScanShape shape;
  shape.tracks = static_cast<int>(state.range(0));
  shape.plots = static_cast<int>(state.range(1));
  solve(state, name, testing::random_scan(shape, 1));
}

/// 200 tracks and 300 plots in an area 200 long; gates of tenths.
void area(benchmark::State& state, const char* name, const testing::ScanShape& plain) {
  testing::ScanShape shape = plain;
  shape.tracks = 200;
  shape.plots = 300;
  shape.length = 200.0;
  shape.gate = 0.1 * static_cast<double>(state.range(0));
  solve(state, name, testing::random_scan(shape, 1));
}

void strip(benchmark::State& state, const char* name) { area(state, name, {}); }

void square(benchmark::State& state, const char* name) { area(state, name, {.height = 200.0}); }

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({4, 6})->Args({10, 14})->Args({16, 21})->Args({20, 25});
  benchmark->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(dense, jpda, "jpda")->Apply(sizes)->Args({22, 27});
BENCHMARK_CAPTURE(dense, lbp, "lbp")->Apply(sizes);
BENCHMARK_CAPTURE(dense, jpda_cheap, "jpda-cheap")->Apply(sizes);
BENCHMARK_CAPTURE(dense, pda, "pda")->Apply(sizes);
BENCHMARK_CAPTURE(dense, gnn, "gnn")->Apply(sizes);
BENCHMARK_CAPTURE(strip, jpda, "jpda")
    ->Arg(10)
    ->Arg(20)
    ->Arg(30)
    ->Arg(40)
    ->Arg(50)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(strip, lbp, "lbp")->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(square, jpda, "jpda")->Arg(80)->Arg(110)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(square, lbp, "lbp")->Arg(80)->Arg(110)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mda

int main(int argc, char** argv) { return mda::testing::bench_main(argc, argv); }
