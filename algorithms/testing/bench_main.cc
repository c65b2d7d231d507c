#include "algorithms/testing/bench_main.h"

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace mda::testing {
namespace {

constexpr int kBadUsage = 2;

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + '"';
}

std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

using Run = benchmark::BenchmarkReporter::Run;

std::string line_of(const Run& run) {
  const std::string start = "{\"name\": " + quoted(run.benchmark_name());
  if (run.error_occurred) return start + ", \"error\": " + quoted(run.error_message) + "}";
  const double iterations = static_cast<double>(run.iterations);
  std::string counters;
  for (const auto& [name, counter] : run.counters) {
    counters += (counters.empty() ? "" : ", ") + quoted(name) + ": " + digits(counter.value);
  }
  return start + ", \"cpu_s\": " + digits(run.cpu_accumulated_time / iterations) +
         ", \"wall_s\": " + digits(run.real_accumulated_time / iterations) + ", \"counters\": {" +
         counters + "}}";
}

class LineReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    if (runs.front().run_type == Run::RT_Aggregate) return;
    const auto takes_less = [](const Run& a, const Run& b) {
      return a.cpu_accumulated_time / static_cast<double>(a.iterations) <
             b.cpu_accumulated_time / static_cast<double>(b.iterations);
    };
    std::cout << line_of(*std::min_element(runs.begin(), runs.end(), takes_less)) << std::endl;
  }
};

int take_turns() {
  LineReporter reporter;
  for (std::string line; std::getline(std::cin, line);) {
    if (benchmark::RunSpecifiedBenchmarks(&reporter) == 0) return kBadUsage;
  }
  return 0;
}

}  // namespace

int bench_main(int argc, char** argv) {
  // As in the main() of mda-bench. Otherwise page faults make some processes several times slower
  // than others, each for its lifetime, by where their heaps happen to end.
  mallopt(M_TOP_PAD, 64 << 20);
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  char** const end = argv + argc;
  char** const kept = std::remove_if(
      argv, end, [](const char* word) { return std::string_view(word) == "--turns"; });
  const bool turns = kept != end;
  argc = static_cast<int>(kept - argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return kBadUsage;
  if (turns) return take_turns();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace mda::testing
