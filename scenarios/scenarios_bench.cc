// Kernels of the hypothesis tree on the scenes of groups A-D, one thread. Items are hypotheses,
// leaves or tracks; times are those of the thread's CPU clock.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <memory>
#include <vector>

#include "algorithms/testing/bench_main.h"
#include "scenarios/filter/ekf.h"
#include "scenarios/groups.h"
#include "scenarios/hypotheses/extract.h"
#include "scenarios/hypotheses/lanes.h"
#include "scenarios/hypotheses/track_forest.h"
#include "scenarios/testing/choices.h"
#include "scenarios/world/simulate.h"

namespace mda {
namespace {

/// Played side by side, so that the clock is read once for all of them, and that no scene finds its
/// forest in the nearest cache.
constexpr int kReplicates = 8;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A scene, its forest, and what is decided in it scan by scan.
struct Game {
  std::vector<Scan> scans;
  std::vector<std::vector<int>> chosen_leaves;
  TrackForest forest;
};

/// Plays a scene once with the cheapest choice, which grows the buffers too.
std::unique_ptr<Game> recorded_game(const ScenarioSpec& spec, int window_k, int replicate) {
  auto game = std::make_unique<Game>();
  game->scans = simulate(spec, 1, replicate).scans;
  game->forest.reset(spec.world, spec.model, window_k);
  WindowExtractor extractor;
  for (const Scan& scan : game->scans) {
    game->forest.grow(scan);
    const WindowInstance window = extractor.extract(game->forest);
    game->chosen_leaves.push_back(
        testing::leaves_of(window, testing::cheapest_that_fit(window.problem)));
    game->forest.decide(game->chosen_leaves.back());
  }
  return game;
}

enum class Phase { kGrow, kExtract, kDecide };
constexpr std::size_t kPhases = 3;

struct Work {
  std::array<double, kPhases> seconds{};
  std::int64_t hypotheses = 0;
  std::int64_t columns = 0;
  std::int64_t scans = 0;
};

/// Plays all games from the start.
Work play(std::vector<std::unique_ptr<Game>>& games, const ScenarioSpec& spec, int window_k) {
  Work work;
  WindowExtractor extractor;
  const auto timed = [&](Phase phase, const auto& job) {
    const double start = cpu_seconds();
    for (auto& game : games) job(*game);
    work.seconds[static_cast<std::size_t>(phase)] += cpu_seconds() - start;
  };
  for (auto& game : games) game->forest.reset(spec.world, spec.model, window_k);
  for (std::size_t scan = 0; scan < games[0]->scans.size(); ++scan) {
    timed(Phase::kGrow, [&](Game& game) { game.forest.grow(game.scans[scan]); });
    timed(Phase::kExtract,
          [&](Game& game) { work.columns += extractor.extract(game.forest).problem.columns(); });
    timed(Phase::kDecide, [&](Game& game) { game.forest.decide(game.chosen_leaves[scan]); });
    work.scans += static_cast<std::int64_t>(games.size());
  }
  for (const auto& game : games) work.hypotheses += game->forest.hypotheses();
  return work;
}

/// Times one phase of playing all scenes: an iteration is kReplicates scenes.
void replay(benchmark::State& state, Phase phase, const char* group) {
  const ScenarioSpec& spec = *find_scenario(group);
  const int window_k = static_cast<int>(state.range(0));
  std::vector<std::unique_ptr<Game>> games;
  for (int replicate = 1; replicate <= kReplicates; ++replicate) {
    games.push_back(recorded_game(spec, window_k, replicate));
  }
  Work all;
  while (state.KeepRunning()) {
    const Work work = play(games, spec, window_k);
    state.SetIterationTime(work.seconds[static_cast<std::size_t>(phase)]);
    all.hypotheses += work.hypotheses;
    all.columns += work.columns;
    all.scans += work.scans;
  }
  using benchmark::Counter;
  const auto rate = [](std::int64_t n) {
    return Counter(static_cast<double>(n), Counter::kIsRate);
  };
  state.counters["scans/s"] = rate(all.scans);
  if (phase == Phase::kGrow) state.counters["hypotheses/s"] = rate(all.hypotheses);
  if (phase == Phase::kExtract) state.counters["columns/s"] = rate(all.columns);
}

void grow(benchmark::State& state, const char* group) { replay(state, Phase::kGrow, group); }
void extract(benchmark::State& state, const char* group) { replay(state, Phase::kExtract, group); }
void decide(benchmark::State& state, const char* group) { replay(state, Phase::kDecide, group); }

/// A target on its way out, after some updates.
Gaussian settled_state(const World& world) {
  const Plot first{20.0, 0.7, kFalseAlarm};
  const Plot second{22.0, 0.71, kFalseAlarm};
  return two_plot_state(world, {}, first, second, 1);
}

/// Loses a factor of three when the loop is no longer vectorised. Targets stand still, so that a
/// second call finds the states of the first.
void predict_lanes(benchmark::State& state, PredictLanes version) {
  const World world;
  const LaneModel model{world.range_sigma_km * world.range_sigma_km,
                        world.bearing_sigma_rad * world.bearing_sigma_rad, 0.0, 9.21};
  const Gaussian settled = settled_state(world);
  const auto lanes = std::make_unique<Lanes>();
  for (int lane = 0; lane < kLanes; ++lane) {
    LaneState packed{{10.0 + lane, 0.0, 5.0, 0.0}, {}};
    for (int row = 0, entry = 0; row < 4; ++row) {
      for (int column = row; column < 4; ++column) {
        packed.p[entry++] = settled.covariance(row, column);
      }
    }
    lanes->put(lane, packed);
    lanes->dt[lane] = world.scan_period_s;
  }
  while (state.KeepRunning()) {
    version(model, 1.0, 100.0, *lanes, kLanes);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * kLanes);
}

void predict_baseline(benchmark::State& state) { predict_lanes(state, predict_lanes_baseline()); }
void predict_this_cpu(benchmark::State& state) {
  predict_lanes(state, predict_lanes_for_this_cpu());
}

/// The plain filter: one prediction and one update.
void filter_step(benchmark::State& state) {
  const World world;
  const Gaussian settled = settled_state(world);
  const Plot plot{24.0, 0.72, kFalseAlarm};
  while (state.KeepRunning()) {
    const Gaussian predicted = predict(world, settled);
    const Innovation expected = innovation(world, predicted);
    benchmark::DoNotOptimize(update(predicted, expected, plot));
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(predict_baseline);
BENCHMARK(predict_this_cpu);
BENCHMARK(filter_step);

void windows(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("K")->Arg(3)->Arg(5)->Arg(7)->UseManualTime()->Unit(benchmark::kMicrosecond);
}

BENCHMARK_CAPTURE(grow, A, "A")->Apply(windows);
BENCHMARK_CAPTURE(grow, B, "B")->Apply(windows);
BENCHMARK_CAPTURE(grow, C, "C")->Apply(windows);
BENCHMARK_CAPTURE(grow, D, "D")->Apply(windows);
BENCHMARK_CAPTURE(extract, A, "A")->Apply(windows);
BENCHMARK_CAPTURE(extract, B, "B")->Apply(windows);
BENCHMARK_CAPTURE(extract, C, "C")->Apply(windows);
BENCHMARK_CAPTURE(extract, D, "D")->Apply(windows);
BENCHMARK_CAPTURE(decide, A, "A")->Apply(windows);
BENCHMARK_CAPTURE(decide, B, "B")->Apply(windows);
BENCHMARK_CAPTURE(decide, C, "C")->Apply(windows);
BENCHMARK_CAPTURE(decide, D, "D")->Apply(windows);

}  // namespace
}  // namespace mda

int main(int argc, char** argv) { return mda::testing::bench_main(argc, argv); }
