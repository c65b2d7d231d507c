// The two-dimensional assignment under gnn, lagrangian-sd and mht: n tracks on a line, each with
// the plots in its gate, about five, costs as of squared distances.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "algorithms/backends/assignment.h"
#include "algorithms/testing/bench_main.h"
#include "algorithms/testing/draw.h"

namespace mda {
namespace {

SparseCosts gated_scan(int tracks, std::uint64_t seed) {
  constexpr double kGate = 2.5;
  testing::Draw draw(seed);
  SparseCosts costs;
  costs.columns = tracks;
  std::vector<double> plots;
  for (int j = 0; j < tracks; ++j) plots.push_back(tracks * draw.unit());
  costs.row_begin.push_back(0);
  for (int i = 0; i < tracks; ++i) {
    const double place = tracks * draw.unit();
    for (int j = 0; j < tracks; ++j) {
      const double distance = plots[static_cast<std::size_t>(j)] - place;
      if (distance * distance > kGate * kGate) continue;
      costs.column.push_back(j);
      costs.cost.push_back(distance * distance - 4.0);
    }
    costs.row_begin.push_back(static_cast<int>(costs.column.size()));
    costs.alone.push_back(0.0);
  }
  return costs;
}

/// Several scans, so that no single lucky one is measured; an iteration is all of them.
void assignment(benchmark::State& state) {
  constexpr std::uint64_t kScans = 8;
  std::vector<SparseCosts> scans;
  for (std::uint64_t seed = 1; seed <= kScans; ++seed) {
    scans.push_back(gated_scan(static_cast<int>(state.range(0)), seed));
  }
  AssignmentSolver solver;
  while (state.KeepRunning()) {
    for (const SparseCosts& costs : scans) benchmark::DoNotOptimize(solver.solve(costs).cost);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kScans));
}

BENCHMARK(assignment)->Arg(100)->Arg(400)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mda

int main(int argc, char** argv) { return mda::testing::bench_main(argc, argv); }
