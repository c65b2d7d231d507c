#include "harness/run_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/errors.h"
#include "harness/files.h"
#include "harness/messages.h"
#include "harness/row.h"
#include "harness/spec_json.h"

namespace mda {
namespace {

using Json = nlohmann::ordered_json;

CellName name_of(const nlohmann::json& line) {
  return {line.at("scenario").get<std::string>(), line.at("scan_period_s").get<double>(),
          line.at("replicate").get<int>(), line.at("window_k").get<int>()};
}

Sweep sweep_of(const Json& manifest, const std::string& file) {
  const Json& json = manifest.at("sweep");
  Sweep sweep;
  sweep.name = json.at("name").get<std::string>();
  sweep.scan_periods_s = json.at("scan_periods_s").get<std::vector<double>>();
  sweep.seed = json.at("seed").get<std::uint64_t>();
  sweep.driver = json.at("driver").get<std::string>();
  sweep.algorithms = json.at("algorithms").get<std::vector<std::string>>();
  for (const Json& plan : json.at("plans")) {
    if (plan.at("loop") != "open") continue;
    const auto name = plan.at("scenario").get<std::string>();
    const std::string where = fmt::format("{}: scenarios.{}", file, name);
    sweep.scenarios.push_back(
        {.spec = spec_of(name, manifest.at("scenarios").at(name), where),
         .windows = plan.at("windows").get<std::vector<int>>(),
         .replicates = plan.at("replicates").get<int>(),
         .scan_periods_s = plan.at("scan_periods_s").get<std::vector<double>>(),
         .algorithms = plan.at("algorithms").get<std::vector<std::string>>(),
         .every = plan.at("every").get<int>(),
         .first_replicate = plan.value("first_replicate", 1)});
  }
  if (sweep.scenarios.empty()) {
    throw InputError(file + ": a closed-loop run has no answers to check");
  }
  check(sweep, file + ": ");
  return sweep;
}

}  // namespace

RunFiles::RunFiles(const std::filesystem::path& directory) {
  read_manifest((directory / "manifest.json").string());
  rows_ = read_regular_file((directory / "rows.jsonl").string());
  answers_ = read_regular_file((directory / "answers.jsonl").string());
  index((directory / "rows.jsonl").string(), rows_, &CellLines::rows);
  index((directory / "answers.jsonl").string(), answers_, &CellLines::answers);
  read_scenes(directory / "scenes.jsonl");
  // A run that was killed may have lost more than the end of a line.
  if (outcome_ == "finished" || (torn_.empty() && outcome_ != "running")) return;
  mark_the_last(&CellLines::rows);
  mark_the_last(&CellLines::answers);
}

/// Of the cells, in the order of a file.
void RunFiles::mark_the_last(std::vector<FileLine> CellLines::*lines) {
  CellLines* last = nullptr;
  int last_number = 0;
  for (auto& [name, cell] : cells_) {
    if ((cell.*lines).empty() || (cell.*lines).back().number <= last_number) continue;
    last = &cell;
    last_number = (cell.*lines).back().number;
  }
  if (last != nullptr) last->may_be_cut = true;
}

void RunFiles::read_manifest(const std::string& file) {
  const std::string text = read_regular_file(file);
  try {
    const Json manifest = Json::parse(text);
    if (manifest.at("schema_version") != kSchemaVersion) {
      throw InputError(fmt::format("{}: its schema_version is not {}", file, kSchemaVersion));
    }
    outcome_ = manifest.at("outcome").get<std::string>();
    cells_failed_ = manifest.at("summary").at("open_loop_cells_failed").get<int>();
    sweep_ = sweep_of(manifest, file);
  } catch (const Json::exception& error) {
    throw InputError(
        fmt::format("{}: it is not the manifest of a run: {}", file, plain_words(error)));
  }
}

template <typename Take>
void RunFiles::each_line(const std::string& file, const std::string& text, Take take) {
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    ++number;
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line(text.data() + begin, end - begin);
    begin = end + 1;
    if (end == text.size() && !nlohmann::json::accept(line)) {
      torn_.push_back(fmt::format("{}:{}", file, number));
      return;
    }
    try {
      take(nlohmann::json::parse(line), FileLine{number, line});
    } catch (const nlohmann::json::exception&) {
      throw InputError(fmt::format("{}:{}: it is not a line of a run", file, number));
    }
  }
}

void RunFiles::index(const std::string& file, const std::string& text,
                     std::vector<FileLine> CellLines::*lines) {
  each_line(file, text, [&](const nlohmann::json& json, const FileLine& line) {
    (cells_[name_of(json)].*lines).push_back(line);
  });
}

/// Scenes are written first: of the last cell of a run that was killed there may be nothing else.
void RunFiles::read_scenes(const std::filesystem::path& path) {
  has_scenes_ = std::filesystem::exists(path);
  if (!has_scenes_) return;
  scenes_ = read_regular_file(path.string());
  each_line(path.string(), scenes_, [&](const nlohmann::json& json, const FileLine& line) {
    const auto cell = cells_.find(name_of(json));
    if (json.at("loop") == "open" && cell != cells_.end()) cell->second.scenes.push_back(line);
  });
}

}  // namespace mda
