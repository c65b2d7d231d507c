// Small runs, read back from their files.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "harness/run.h"

namespace mda::testing {

/// Every line of a .jsonl file; throws if one is not JSON.
[[nodiscard]] std::vector<nlohmann::json> lines_of(const std::filesystem::path& path);

/// Scenario, replicate and K of a row: what one forest is made for.
using CellKey = std::tuple<std::string, int, int>;
/// And the scan.
using WindowKey = std::tuple<std::string, int, int, int>;

[[nodiscard]] CellKey cell_of(const nlohmann::json& row);
[[nodiscard]] WindowKey window_of(const nlohmann::json& row);

/// Three cells, all algorithms: two widths of group A, and group C for its fractional windows.
[[nodiscard]] Sweep small_sweep();

struct RecordedRun {
  RunRecord record;
  std::vector<nlohmann::json> rows;
  std::vector<nlohmann::json> answers;
  nlohmann::json manifest;
};

/// Runs the sweep in a directory that goes away.
[[nodiscard]] RecordedRun recorded_run(const Sweep& sweep, int workers,
                                       const std::atomic<bool>& interrupted);
[[nodiscard]] RecordedRun recorded_run(const Sweep& sweep, int workers);

}  // namespace mda::testing
