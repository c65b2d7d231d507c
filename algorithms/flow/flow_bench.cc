// Flow codes on graphs as tracking makes them: windows with known tracks and whole recordings.
#include <benchmark/benchmark.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/backends/growing_assignment.h"
#include "algorithms/flow/flow_codes.h"
#include "algorithms/testing/bench_main.h"
#include "algorithms/testing/tracking_graphs.h"

namespace mda {
namespace {

struct NamedShape {
  const char* name;
  testing::TrackingShape shape;
};

/// From easy to hard; 10^5 arcs and more, in the last ones 10^6.
const std::vector<NamedShape>& tracking_shapes() {
  static const std::vector<NamedShape> kShapes = {
      {"hundreds", {.scans = 50, .targets = 380, .clutter = 58, .side = 1400.0}},
      {"gated", {.scans = 150, .targets = 100, .clutter = 60, .side = 300.0}},
      {"dense", {.scans = 60, .targets = 60, .clutter = 20, .gate = 0.0, .reach = 1}},
      {"short", {.scans = 50, .targets = 400, .mean_life = 4.0, .clutter = 80, .side = 500.0}},
      {"long", {.scans = 3000, .targets = 8, .clutter = 6, .side = 60.0, .reach = 3}},
      {"crowd", {.scans = 60, .targets = 300, .clutter = 80, .side = 250.0}},
      {"rndsparse", {.scans = 100, .clutter = 200, .reach = 1}},
      {"rnddense", {.scans = 30, .clutter = 100, .reach = 1, .links = 0.0}},
      {"ties", {.scans = 100, .clutter = 100, .reach = 1, .links = 10.0, .whole_numbers = true}},
      {"weak",
       {.scans = 200,
        .clutter = 100,
        .reach = 1,
        .worst_link = 2.0,
        .end_cost = 50.0,
        .point_cost = -1.0}},
      {"hundreds_few_ends",
       {.scans = 50, .targets = 380, .clutter = 58, .side = 1400.0, .terminals = 0.15}},
      {"gated_few_ends",
       {.scans = 150, .targets = 100, .clutter = 60, .side = 300.0, .terminals = 0.15}},
      {"rndsparse_few_ends", {.scans = 100, .clutter = 200, .reach = 1, .terminals = 0.15}},
      {"weak_few_ends",
       {.scans = 200,
        .clutter = 100,
        .reach = 1,
        .worst_link = 2.0,
        .end_cost = 50.0,
        .terminals = 0.15,
        .point_cost = -1.0}},
      {"gated1M", {.scans = 500, .targets = 150, .clutter = 60, .side = 350.0}},
      {"dense1M", {.scans = 60, .targets = 120, .clutter = 30, .gate = 0.0, .reach = 1}},
      {"rnddense1M", {.scans = 26, .clutter = 200, .reach = 1, .links = 0.0}},
      {"short1M", {.scans = 200, .targets = 400, .mean_life = 4.0, .clutter = 80, .side = 500.0}},
  };
  return kShapes;
}

/// Graphs are made once, when they are first asked for.
const FlowGraph& graph(const std::string& name, const std::function<FlowGraph()>& make) {
  static std::map<std::string, FlowGraph> kept;
  const auto found = kept.find(name);
  return found != kept.end() ? found->second : kept.emplace(name, make()).first->second;
}

void solve(benchmark::State& state, const FlowCode& code, const std::string& name,
           const std::function<FlowGraph()>& make) {
  const FlowGraph& problem = graph(name, make);
  FlowResult result;
  while (state.KeepRunning()) {
    result = code.solve(problem);
    benchmark::DoNotOptimize(result.flow.data());
  }
  if (result.outcome != FlowOutcome::kOptimal) state.SkipWithError("no optimum");
  state.counters["arcs"] = static_cast<double>(problem.arcs.size());
}

/// The simplex method would take minutes on the large ones, and capacity scaling where there are as
/// many paths as in tracking graphs; on windows it is often the fastest of LEMON's.
bool is_for_windows(const FlowCode& code) { return code.name == "scf-capacityscaling"; }
bool is_for_small_graphs(const FlowCode& code) { return code.name == "scf-lp"; }

void add([[maybe_unused]] const std::string& name,
         [[maybe_unused]] const std::function<void(benchmark::State&)>& run) {
#ifndef __clang_analyzer__  // it takes what the library keeps for a leak
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
#endif
}

void add(const FlowCode& code, const std::string& name, const std::function<FlowGraph()>& make) {
  add(name + "/" + std::string(code.name),
      [&code, name, make](benchmark::State& state) { solve(state, code, name, make); });
}

void add_all() {
  for (const bool is_gated : {true, false}) {
    for (const int tracks : {20, 100, 500}) {
      for (const int scans : {3, 5, 8}) {
        const std::string name = std::string(is_gated ? "gated" : "ungated") +
                                 "_window/K:" + std::to_string(scans) +
                                 "/T:" + std::to_string(tracks);
        for (const FlowCode& code : flow_codes()) {
          if (is_for_small_graphs(code) && tracks > (is_gated ? 100 : 20)) continue;
          add(code, name, [=] { return testing::window_graph(scans, tracks, is_gated, 1); });
        }
      }
    }
  }
  for (const NamedShape& named : tracking_shapes()) {
    for (const FlowCode& code : flow_codes()) {
      if (is_for_small_graphs(code) || is_for_windows(code)) continue;
      add(code, named.name, [&named] { return testing::tracking_graph(named.shape, 1); });
    }
  }
}

constexpr std::size_t kSettledScans = 50;

/// The mean time to append one of the scans 51 to 100 and to have the optimum of all.
void append(benchmark::State& state, const testing::TrackingShape& shape) {
  const auto scans = testing::tracking_scans(shape, 1);
  std::unique_ptr<GrowingAssignment> growing;
  std::size_t next = scans.size();
  const auto append_next = [&] {
    for (const testing::GrowingDetection& detection : scans[next]) {
      growing->add_detection(detection.cost, *detection.entry, *detection.exit);
      for (const auto& link : detection.links) growing->add_link(link.from, link.cost);
    }
    growing->update();
    ++next;
  };
  while (state.KeepRunning()) {
    if (next == scans.size()) {
      state.PauseTiming();
      growing = std::make_unique<GrowingAssignment>();
      for (next = 0; next < kSettledScans;) append_next();
      state.ResumeTiming();
    }
    append_next();
  }
}

void add_growing() {
  for (NamedShape named : tracking_shapes()) {
    if (std::string_view(named.name).ends_with("1M") || named.shape.terminals < 1.0) continue;
    named.shape.scans = 2 * static_cast<int>(kSettledScans);
    const std::string name = std::string("scan_") + named.name;
    add(name + "/append", [=](benchmark::State& state) { append(state, named.shape); });
    for (const FlowCode& code : flow_codes()) {
      if (is_for_small_graphs(code) || is_for_windows(code)) continue;
      add(code, name, [=] {
        return testing::graph_of_scans(testing::tracking_scans(named.shape, 1), kSettledScans);
      });
    }
  }
}

}  // namespace
}  // namespace mda

int main(int argc, char** argv) {
  mda::add_all();
  mda::add_growing();
  return mda::testing::bench_main(argc, argv);
}
