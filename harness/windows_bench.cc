// Algorithms on frozen windows: the files SET/*.json of a directory ('mda-bench export'), so that
// every revision solves the same problems. scripts/nightly.sh times and counts with it.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/catalog.h"
#include "harness/errors.h"
#include "harness/files.h"
#include "harness/referee.h"
#include "harness/window_file.h"

namespace mda {
namespace {

constexpr const char* kUsage =
    "usage: windows_bench --windows=DIR [--passes=N] [GOOGLE-BENCHMARK-ARGUMENT...]\n\n"
    "Registers SET/ALGORITHM for every folder SET of window files (JSON) in DIR and every "
    "algorithm\n"
    "that takes columns alone. An iteration is N passes [1] over the windows of the set, and "
    "there\n"
    "is one iteration: the work does not depend on the clock. Counters are sums over one pass;\n"
    "'problems' is a number made of the fingerprints: sets that differ in it are not the same.\n";

struct Options {
  std::string windows;
  int passes = 1;
};

/// What a pass did, so that equal times of unequal work are noticed.
struct Work {
  std::int64_t iterations = 0;
  std::int64_t nodes = 0;
  double cost = 0.0;
};

/// Of the .json files of `set`, in the order of their names.
std::vector<AssociationProblem> read_windows(const std::filesystem::path& set) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(set)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  std::vector<AssociationProblem> problems;
  problems.reserve(files.size());
  for (const std::string& file : files) problems.push_back(parse_window(read_file(file), file));
  return problems;
}

/// A whole number below 2^32, which a double keeps, of fingerprints in their order (FNV-1a).
double number_of(const std::vector<AssociationProblem>& problems) {
  std::uint32_t hash = 2166136261U;
  for (const AssociationProblem& problem : problems) {
    for (const char digit : problem.fingerprint()) {
      hash = (hash ^ static_cast<unsigned char>(digit)) * 16777619U;
    }
  }
  return hash;
}

Work work_of(Associator& solver, const std::vector<AssociationProblem>& problems) {
  Work work;
  for (const AssociationProblem& problem : problems) {
    const Solution solution = solver.solve(problem, Budget{});
    work.iterations += solution.stats.iterations.value_or(0);
    work.nodes += solution.stats.nodes.value_or(0);
    work.cost += examine(problem, solution.x).cost;
  }
  return work;
}

void solve(benchmark::State& state, const CatalogEntry& entry, const std::filesystem::path& set,
           int passes) {
  const std::vector<AssociationProblem> problems = read_windows(set);
  const auto solver = entry.make();
  for (const AssociationProblem& problem : problems) {
    const Verdict verdict = solver->can_solve(problem.shape());
    if (!verdict.ok) return state.SkipWithError(verdict.reason.c_str());
  }
  const Work work = work_of(*solver, problems);  // grows the solver's buffers, too
  while (state.KeepRunning()) {
    for (int pass = 0; pass < passes; ++pass) {
      for (const AssociationProblem& problem : problems) {
        benchmark::DoNotOptimize(solver->solve(problem, Budget{}).x.data());
      }
    }
  }
  state.counters["windows"] = static_cast<double>(problems.size());
  state.counters["problems"] = number_of(problems);
  state.counters["solver_iterations"] = static_cast<double>(work.iterations);
  state.counters["solver_nodes"] = static_cast<double>(work.nodes);
  state.counters["cost"] = work.cost;
}

void add_all(const Options& options) {
  std::vector<std::filesystem::path> sets;
  for (const auto& entry : std::filesystem::directory_iterator(options.windows)) {
    if (entry.is_directory()) sets.push_back(entry.path());
  }
  std::sort(sets.begin(), sets.end());
  for (const auto& set : sets) {
    for (const CatalogEntry& entry : catalog()) {
      if (entry.make()->traits().needs_views()) continue;
      const std::string name = set.filename().string() + "/" + std::string(entry.name);
      const int passes = options.passes;
#ifndef __clang_analyzer__  // it takes what the library keeps for a leak
      benchmark::RegisterBenchmark(
          name.c_str(),
          [&entry, set, passes](benchmark::State& state) { solve(state, entry, set, passes); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
#endif
    }
  }
}

/// Takes its own arguments out of argv; the rest is for Google Benchmark.
Options parse(int& argc, char** argv) {
  Options options;
  int kept = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word.starts_with("--windows=")) {
      options.windows = word.substr(word.find('=') + 1);
    } else if (word.starts_with("--passes=")) {
      const std::string_view text = word.substr(word.find('=') + 1);
      const auto [end, error] =
          std::from_chars(text.data(), text.data() + text.size(), options.passes);
      if (error != std::errc{} || end != text.data() + text.size() || options.passes < 1) {
        throw InputError(fmt::format("--passes='{}' is not a whole number from 1", text));
      }
    } else {
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  if (!std::filesystem::is_directory(options.windows)) {
    throw InputError(fmt::format("--windows='{}' is not a directory\n{}", options.windows, kUsage));
  }
  return options;
}

int run(int argc, char** argv) {
  add_all(parse(argc, argv));
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return kBadInput;
  const std::size_t matched = benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return matched > 0 ? kWell : kBadInput;
}

}  // namespace
}  // namespace mda

int main(int argc, char** argv) {
  try {
    return mda::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "windows_bench: {}\n", error.what());
    return mda::kBadInput;
  }
}
