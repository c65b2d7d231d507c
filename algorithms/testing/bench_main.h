// The main() of every *_bench program: Google Benchmark's, and one that takes turns.
#pragma once

namespace mda::testing {

/// As BENCHMARK_MAIN(). With --turns, the benchmarks that match the filter run once for every line
/// on standard input, and each time a line of JSON answers, of the repetition that took the least
/// CPU time (caches are cold in the first one, and another process can only add):
///   {"name": ..., "cpu_s": ..., "wall_s": ..., "counters": {...}}   seconds of one iteration
///   {"name": ..., "error": ...}
/// so that two programs can be timed alternately, turn by turn, while both are warm: whatever the
/// machine does to one it does to the other. Exit code 0, or 2 if an argument is unknown or, with
/// --turns, no benchmark matches.
int bench_main(int argc, char** argv);

}  // namespace mda::testing
