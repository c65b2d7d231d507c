// Runs a sweep: cells in parallel, each by one worker from its first scan to its last.
#pragma once

#include <atomic>
#include <filesystem>

#include "harness/manifest.h"
#include "harness/sweep.h"

namespace mda {

/// `asked`, or one worker per processor if that is 0.
[[nodiscard]] int worker_count(int asked);

/// Writes the run's files into `directory` as cells finish. Returns what the manifest ends with.
/// Throws InputError if the directory cannot be used (then nothing is run) and DiskError if writing
/// fails (finished cells stay). Stops soon after `interrupted` is set. Rows do not depend on the
/// number of workers but for times.
RunRecord run_sweep(const Sweep& sweep, const std::filesystem::path& directory, int workers,
                    const std::vector<std::string>& arguments,
                    const std::atomic<bool>& interrupted);

}  // namespace mda
