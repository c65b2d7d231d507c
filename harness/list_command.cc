#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "algorithms/catalog.h"
#include "harness/commands.h"
#include "scenarios/groups.h"

namespace mda {
namespace {

using Json = nlohmann::ordered_json;

Json algorithms() {
  Json list = Json::array();
  for (const CatalogEntry& entry : catalog()) {
    const Traits traits = entry.make()->traits();
    list.push_back({{"name", entry.name},
                    {"family", entry.family},
                    {"answer", word(traits.answer)},
                    {"exact", traits.exact},
                    {"bounds", traits.bounds},
                    {"certifies", traits.certifies},
                    {"randomized", traits.randomized},
                    {"reference", entry.reference},
                    {"source", entry.source},
                    {"summary", entry.summary}});
  }
  return list;
}

Json scenarios() {
  Json list = Json::array();
  for (const ScenarioSpec& spec : scenario_list()) {
    list.push_back({{"name", spec.name},
                    {"scans", spec.world.scans},
                    {"births_per_scan", spec.world.births_per_scan},
                    {"clutter_per_scan", spec.world.clutter_per_scan},
                    {"summary", spec.summary}});
  }
  return list;
}

Json sweeps() {
  Json list = Json::array();
  for (const Sweep& sweep : named_sweeps()) {
    std::int64_t windows = 0;
    for (const ScenarioPlan& plan : sweep.scenarios) {
      const int replicates = plan.replicates - plan.first_replicate + 1;
      windows += static_cast<std::int64_t>(plan.windows.size()) * replicates *
                 plan.spec.world.scans * static_cast<std::int64_t>(sweep.scan_periods_s.size());
    }
    list.push_back({{"name", sweep.name},
                    {"windows", windows},
                    {"algorithms", fmt::format("{}", fmt::join(sweep.algorithms, ","))},
                    {"summary", sweep.summary}});
  }
  return list;
}

std::string text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return value.dump();
}

/// A list of alike objects as a table: a column for each key, as wide as its widest entry.
std::string table_of(const Json& rows) {
  std::vector<std::vector<std::string>> cells(rows.size() + 1);
  for (const auto& [key, value] : rows.front().items()) cells[0].push_back(key);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const Json& value : rows[i]) cells[i + 1].push_back(text_of(value));
  }
  std::string text;
  for (const auto& line : cells) {
    for (std::size_t c = 0; c < line.size(); ++c) {
      std::size_t width = 0;
      for (const auto& other : cells) width = std::max(width, other[c].size());
      text += c + 1 < line.size() ? fmt::format("{:<{}}  ", line[c], width) : line[c] + "\n";
    }
  }
  return text;
}

}  // namespace

int list(const ListCommand& command) {
  const Json rows = command.kind == ListKind::kAlgorithms  ? algorithms()
                    : command.kind == ListKind::kScenarios ? scenarios()
                                                           : sweeps();
  fmt::print("{}", command.json ? rows.dump(2) + "\n" : table_of(rows));
  return 0;
}

}  // namespace mda
