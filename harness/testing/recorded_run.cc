#include "harness/testing/recorded_run.h"

#include <sstream>

#include "harness/files.h"
#include "harness/testing/temporary_directory.h"

namespace mda::testing {

using nlohmann::json;

std::vector<json> lines_of(const std::filesystem::path& path) {
  std::istringstream text(read_file(path.string()));
  std::vector<json> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(json::parse(line));
  return lines;
}

CellKey cell_of(const json& row) { return {row["scenario"], row["replicate"], row["window_k"]}; }

WindowKey window_of(const json& row) {
  return {row["scenario"], row["replicate"], row["window_k"], row["scan"]};
}

Sweep small_sweep() {
  Sweep sweep;
  sweep.name = "small";
  sweep.scenarios = {{scenario_named("A"), {3, 5}, 1}, {scenario_named("C"), {3}, 1}};
  sweep.driver = "exact";
  sweep.algorithms = {"lp", "lp-grp", "cbc", "exact", "greedy", "brute-force"};
  return sweep;
}

RecordedRun recorded_run(const Sweep& sweep, int workers, const std::atomic<bool>& interrupted) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "run";
  RecordedRun run;
  run.record = run_sweep(sweep, path, workers, {"run", "small"}, interrupted);
  run.rows = lines_of(path / "rows.jsonl");
  run.answers = lines_of(path / "answers.jsonl");
  run.manifest = json::parse(read_file((path / "manifest.json").string()));
  return run;
}

RecordedRun recorded_run(const Sweep& sweep, int workers) {
  const std::atomic<bool> interrupted = false;
  return recorded_run(sweep, workers, interrupted);
}

}  // namespace mda::testing
