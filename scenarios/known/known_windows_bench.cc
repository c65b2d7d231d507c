// Making the windows of known tracks, one thread: hypothesis tree, columns and problem. Items are
// nodes of the tree; times are those of the thread's CPU clock.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <ctime>

#include "scenarios/groups.h"
#include "scenarios/known/known_windows.h"
#include "scenarios/testing/known.h"

namespace mda {
namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// An iteration is a run, played by the truth.
void known_windows(benchmark::State& state, const char* scenario) {
  const ScenarioSpec& spec = *find_scenario(scenario);
  const int window_k = static_cast<int>(state.range(0));
  std::int64_t nodes = 0;
  std::int64_t scans = 0;
  while (state.KeepRunning()) {
    KnownTrackWindows windows(spec, 1, 1, window_k);
    double seconds = 0.0;
    while (true) {
      const double start = cpu_seconds();
      const bool more = windows.next();
      seconds += cpu_seconds() - start;
      if (!more) break;
      nodes += windows.window().problem.views()->tree.nodes();
      ++scans;
      windows.advance(testing::true_sequences(windows));
    }
    state.SetIterationTime(seconds);
  }
  state.SetItemsProcessed(nodes);
  state.counters["windows/s"] =
      benchmark::Counter(static_cast<double>(scans), benchmark::Counter::kIsRate);
}

void windows(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("K")->Arg(3)->Arg(5)->UseManualTime()->Unit(benchmark::kMicrosecond);
}

BENCHMARK_CAPTURE(known_windows, battistelli_1_dense, "battistelli-1-dense")->Apply(windows);
BENCHMARK_CAPTURE(known_windows, battistelli_2_radial, "battistelli-2-radial")->Apply(windows);

}  // namespace
}  // namespace mda
