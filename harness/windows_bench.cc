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
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/bench_main.h"
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
    "is one iteration, so that the work does not depend on the clock. Counters are sums over one "
    "pass;\n"
    "'problems' is a number made of the fingerprints: sets that differ in it are not the same.\n";

struct Options {
  std::string windows;
  int passes = 1;
};

/// What a pass does, so that equal times of unequal work are noticed.
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

/// A solver and its windows, ready to go; all repetitions share one.
struct Job {
  std::vector<AssociationProblem> problems;
  std::unique_ptr<Associator> solver;
  std::string declined;  ///< why; empty: it takes the windows
  Work work;
};

Job job_of(const CatalogEntry& entry, const std::filesystem::path& set) {
  Job job{read_windows(set), entry.make(), "", {}};
  for (const AssociationProblem& problem : job.problems) {
    const Verdict verdict = job.solver->can_solve(problem.shape());
    if (!verdict.ok) job.declined = verdict.reason;
  }
  if (job.declined.empty()) job.work = work_of(*job.solver, job.problems);
  return job;
}

void solve(benchmark::State& state, const Job& job, int passes) {
  if (!job.declined.empty()) return state.SkipWithError(job.declined.c_str());
  while (state.KeepRunning()) {
    for (int pass = 0; pass < passes; ++pass) {
      for (const AssociationProblem& problem : job.problems) {
        benchmark::DoNotOptimize(job.solver->solve(problem, Budget{}).x.data());
      }
    }
  }
  state.counters["windows"] = static_cast<double>(job.problems.size());
  state.counters["problems"] = number_of(job.problems);
  state.counters["solver_iterations"] = static_cast<double>(job.work.iterations);
  state.counters["solver_nodes"] = static_cast<double>(job.work.nodes);
  state.counters["cost"] = job.work.cost;
}

void add(const std::string& name, const CatalogEntry& entry, const std::filesystem::path& set,
         int passes) {
  const auto kept = std::make_shared<std::optional<Job>>();
#ifndef __clang_analyzer__  // it takes what the library keeps for a leak
  benchmark::RegisterBenchmark(name.c_str(),
                               [=, &entry](benchmark::State& state) {
                                 if (!*kept) kept->emplace(job_of(entry, set));
                                 solve(state, **kept, passes);
                               })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
#endif
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
      add(set.filename().string() + "/" + std::string(entry.name), entry, set, options.passes);
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

}  // namespace
}  // namespace mda

int main(int argc, char** argv) {
  try {
    mda::add_all(mda::parse(argc, argv));
    return mda::testing::bench_main(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "windows_bench: {}\n", error.what());
    return mda::kBadInput;
  }
}
