// What the harness does with a window, on 20 frozen real windows each of light (A, K = 3), wide
// (A and C, K = 7) and crowded (D, K = 3) skies.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/bench_main.h"
#include "harness/referee.h"
#include "harness/testing/real_windows.h"
#include "harness/window_file.h"
#include "scenarios/static3/sensor_points.h"
#include "scenarios/static3/sensor_window.h"

namespace mda {
namespace {

using Problems = std::vector<AssociationProblem>;

Problems frozen_windows(std::string_view scenario, int window_k) {
  constexpr std::size_t kWindows = 20;
  Problems problems;
  for (int replicate = 1; problems.size() < kWindows; ++replicate) {
    for (AssociationProblem& problem :
         testing::real_windows({scenario, window_k, 8.0, replicate}, 5)) {
      if (problems.size() < kWindows) problems.push_back(std::move(problem));
    }
  }
  return problems;
}

/// Made once per set, as making them costs more than most of what is measured.
const Problems& windows_of(const benchmark::State& state) {
  static std::array<Problems, 4> sets;
  const auto set = static_cast<std::size_t>(state.range(0));
  if (sets[set].empty()) {
    constexpr std::array<std::pair<const char*, int>, 4> kSources = {
        {{"A", 3}, {"A", 7}, {"C", 7}, {"D", 3}}};
    sets[set] = frozen_windows(kSources[set].first, kSources[set].second);
  }
  return sets[set];
}

/// Runs `work(i)` for one window after the other; i is the window's number.
template <typename Work>
void over_windows(benchmark::State& state, Work work) {
  static constexpr std::array<const char*, 4> kLabels = {"A, K = 3", "A, K = 7", "C, K = 7",
                                                         "D, K = 3"};
  const Problems& problems = windows_of(state);
  double columns = 0.0;
  for (const AssociationProblem& problem : problems) columns += problem.columns();
  std::size_t i = 0;
  while (state.KeepRunning()) {
    work(i);
    i = (i + 1) % problems.size();
  }
  state.SetLabel(kLabels[static_cast<std::size_t>(state.range(0))]);
  state.counters["columns"] = columns / static_cast<double>(problems.size());
}

void solve(benchmark::State& state, const char* name) {
  const Problems& problems = windows_of(state);
  const auto solver = find_algorithm(name)->make();
  double round_ms = 0.0;
  over_windows(state, [&](std::size_t i) {
    const Solution solution = solver->solve(problems[i], Budget{});
    round_ms += solution.stats.round_ms.value_or(0.0);
    benchmark::DoNotOptimize(solution.x.data());
  });
  if (round_ms == 0.0) return;
  state.counters["round_us"] =
      benchmark::Counter(1e3 * round_ms, benchmark::Counter::kAvgIterations);
}

std::vector<Solution> relaxations_of(const Problems& problems) {
  const auto lp = find_algorithm("lp")->make();
  std::vector<Solution> solutions;
  for (const AssociationProblem& problem : problems) {
    solutions.push_back(lp->solve(problem, Budget{}));
  }
  return solutions;
}

void referee_examine(benchmark::State& state) {
  const Problems& problems = windows_of(state);
  const std::vector<Solution> solutions = relaxations_of(problems);
  over_windows(state, [&](std::size_t i) {
    benchmark::DoNotOptimize(examine(problems[i], solutions[i].x));
  });
}

void referee_certified_bound(benchmark::State& state) {
  const Problems& problems = windows_of(state);
  const std::vector<Solution> solutions = relaxations_of(problems);
  over_windows(state, [&](std::size_t i) {
    benchmark::DoNotOptimize(certified_bound(problems[i], solutions[i].row_dual));
  });
}

void fingerprint(benchmark::State& state) {
  const Problems& problems = windows_of(state);
  over_windows(state, [&](std::size_t i) { benchmark::DoNotOptimize(problems[i].fingerprint()); });
}

void write_window_json(benchmark::State& state) {
  const Problems& problems = windows_of(state);
  over_windows(state,
               [&](std::size_t i) { benchmark::DoNotOptimize(window_json(problems[i], {})); });
}

void read_window_json(benchmark::State& state) {
  std::vector<std::string> texts;
  for (const AssociationProblem& problem : windows_of(state)) {
    texts.push_back(window_json(problem, {}));
  }
  over_windows(state,
               [&](std::size_t i) { benchmark::DoNotOptimize(parse_window(texts[i], "w.json")); });
}

/// A thousand targets on a random layout under three sensors: the window, and its optimum. The
/// iterations are over different scenes; a proof is part of the bargain.
void thousand_targets(benchmark::State& state, const char* name) {
  constexpr int kTargets = 1000;
  const double sigma = 0.05 * static_cast<double>(state.range(0));
  const ScenarioSpec spec = sensor_point(kTargets, SensorLayout::kRandom, sigma, 0.1);
  const auto solver = find_algorithm(name)->make();
  int replicate = 0;
  double columns = 0.0;
  double proven = 0.0;
  while (state.KeepRunning()) {
    const AssociationProblem problem =
        sensor_window(spec, simulate_sensors(spec, 1, ++replicate)).problem;
    columns += problem.columns();
    proven += solver->solve(problem, Budget{}).status == Status::kOptimal ? 1.0 : 0.0;
  }
  state.SetLabel(spec.name);
  state.counters["columns"] = columns / replicate;
  state.counters["proven"] = proven / replicate;
}

void thousand_targets_window(benchmark::State& state) {
  const ScenarioSpec spec = sensor_point(1000, SensorLayout::kRandom, 0.2, 0.1);
  const SensorScene scene = simulate_sensors(spec, 1, 1);
  while (state.KeepRunning())
    benchmark::DoNotOptimize(sensor_window(spec, scene).problem.columns());
}

BENCHMARK_CAPTURE(thousand_targets, exact, "exact")
    ->DenseRange(2, 6)
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(thousand_targets_window)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, lp, "lp")->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, lp_grp, "lp-grp")->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, exact, "exact")->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, cbc, "cbc")->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, greedy, "greedy")->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(referee_examine)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(referee_certified_bound)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(fingerprint)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(write_window_json)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(read_window_json)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mda

int main(int argc, char** argv) { return mda::testing::bench_main(argc, argv); }
