// Checks a recorded run without running a solver: the windows are made anew from the manifest, the
// recorded answers are judged by the referee again, and every row must come out as it was recorded.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "harness/run_files.h"

namespace mda {

struct Verification {
  std::int64_t windows = 0;
  std::int64_t rows = 0;
  std::int64_t scenes = 0;
  std::int64_t disagreements = 0;
  std::vector<std::string> examples;  ///< the first few, one sentence each

  void disagree(std::string what);
  void add(const Verification& other);
};

/// Looks at everything a row says but times, counts of work and notes; numbers may differ by 1e-6
/// of their size. Rows that failed are only counted: what they answered may be beyond recording.
/// Windows whose fingerprint differs end their cell. Absent rows are disagreements unless the run
/// did not finish. Where a run has scenes, those of its open loop are made anew as well. An answer
/// whose row was not asked for is compared with the row recorded with it. Deterministic.
[[nodiscard]] Verification verify_run(const RunFiles& files, int workers,
                                      const std::atomic<bool>& interrupted);

}  // namespace mda
