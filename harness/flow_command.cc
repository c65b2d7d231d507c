#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/catalog.h"
#include "harness/clocks.h"
#include "harness/commands.h"
#include "harness/errors.h"
#include "harness/files.h"
#include "harness/flow_file.h"
#include "harness/flow_paths.h"
#include "harness/flow_referee.h"
#include "harness/messages.h"

namespace mda {
namespace {

using Json = nlohmann::ordered_json;
using Paths = std::vector<std::vector<int>>;

const FlowCode& find_code(const std::string& name) {
  if (const FlowCode* const code = find_flow_code(name)) return *code;
  std::string names;
  for (const FlowCode& code : flow_codes()) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", code.name);
  }
  throw InputError(fmt::format("unknown flow code '{}': there are {}", name, names));
}

struct Judged {
  FlowResult result;
  FlowVerdict verdict;
  Elapsed elapsed;
};

/// The first line of an arc at the node, in brackets; nothing for a node without arcs.
std::string line_of(const FlowFile& file, int node) {
  const auto at_node = [&](const FlowArc& arc) { return arc.tail == node || arc.head == node; };
  const auto& arcs = file.graph.arcs;
  const auto arc = std::find_if(arcs.begin(), arcs.end(), at_node);
  if (arc == arcs.end()) return {};
  return fmt::format(" (line {})", file.line[static_cast<std::size_t>(arc - arcs.begin())]);
}

/// What a code says of a graph that it does not take, with the file's number of the node.
std::string reason_of(const FlowFile& file, const FlowResult& declined) {
  const int node = declined.reason_node;
  if (node < 0) return declined.reason;
  return fmt::format("{}, node {}{}", declined.reason, node + 1, line_of(file, node));
}

Judged solved(const FlowCode& code, const FlowFile& file, const std::string& path) {
  try {
    Judged judged;
    const Stopwatch watch;
    judged.result = code.solve(file.graph);
    judged.elapsed = {watch.wall_ms(), watch.cpu_ms()};
    if (judged.result.outcome == FlowOutcome::kDeclined) {
      throw InputError(
          fmt::format("{}: '{}' declines: {}", path, code.name, reason_of(file, judged.result)));
    }
    judged.verdict = judge_flow(file, judged.result);
    return judged;
  } catch (const std::overflow_error& error) {
    throw InputError(fmt::format("{}: its numbers are too large: {}", path, error.what()));
  }
}

template <typename Number>
Json or_null(const std::optional<Number>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string_view status_of(const FlowResult& result, const FlowVerdict& verdict) {
  if (!verdict.refutation.empty()) return "failed";
  return result.outcome == FlowOutcome::kOptimal ? "optimal" : "infeasible";
}

/// [tail, head, units] of every arc with flow, in the order and numbers of the file.
std::vector<std::string> used_arcs(const FlowFile& file, const FlowResult& result) {
  std::vector<std::string> used;
  for (std::size_t a = 0; a < result.flow.size(); ++a) {
    const FlowArc& arc = file.graph.arcs[a];
    const std::int64_t units = result.flow[a] + file.lower[a];
    if (units == 0) continue;
    used.push_back(fmt::format("[{}, {}, {}]", arc.tail + 1, arc.head + 1, units));
  }
  return used;
}

/// The nodes of each path, in the numbers of the file.
std::vector<std::string> path_texts(Paths paths, std::string_view between) {
  std::vector<std::string> texts;
  for (std::vector<int>& path : paths) {
    for (int& node : path) ++node;
    texts.push_back(fmt::format("{}", fmt::join(path, between)));
  }
  return texts;
}

/// The object with lists appended that take a line per item.
class JsonText {
 public:
  explicit JsonText(const Json& object) : text_(object.dump(2)) { text_.erase(text_.rfind("\n}")); }
  void add(std::string_view name, const std::vector<std::string>& items) {
    const bool is_empty = items.empty();
    text_ += fmt::format(",\n  \"{}\": [{}{}{}]", name, is_empty ? "" : "\n    ",
                         fmt::join(items, ",\n    "), is_empty ? "" : "\n  ");
  }
  [[nodiscard]] std::string text() const { return text_ + "\n}\n"; }

 private:
  std::string text_;
};

void print_for_machines(const Json& answer, const std::vector<std::string>& arcs,
                        const std::optional<Paths>& paths) {
  JsonText json(answer);
  json.add("used_arcs", arcs);
  if (paths) {
    std::vector<std::string> lists = path_texts(*paths, ", ");
    for (std::string& list : lists) list = fmt::format("[{}]", list);
    json.add("tracks", lists);
  }
  fmt::print("{}", json.text());
}

void print_for_people(const Json& answer, const std::optional<Paths>& paths) {
  for (const auto& [key, value] : answer.items()) {
    if (value.is_null()) continue;
    fmt::print("{:<16} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  if (!paths) return;
  for (const std::string& path : path_texts(*paths, " ")) fmt::print("path             {}\n", path);
}

}  // namespace

int flow(const FlowCommand& command) {
  const FlowCode& code = find_code(command.algorithm);
  const FlowFile file = parse_flow_file(read_file(command.file), command.file);
  if (command.paths && !file.is_tracking()) {
    throw InputError(
        fmt::format("{}: --paths needs a graph in the tracking dialect", command.file));
  }
  const auto [result, verdict, elapsed] = solved(code, file, command.file);
  const Json answer = {{"algorithm", code.name},
                       {"nodes", file.graph.nodes},
                       {"arcs", file.graph.arcs.size()},
                       {"status", status_of(result, verdict)},
                       {"cost", or_null(verdict.cost)},
                       {"certified_bound", or_null(verdict.certified_bound)},
                       {"paths", or_null(verdict.paths)},
                       {"seconds", elapsed.wall_ms / 1e3},
                       {"cpu_seconds", elapsed.cpu_ms / 1e3}};
  const bool is_flow = verdict.cost.has_value();
  std::optional<Paths> paths;
  if (command.paths && is_flow) paths = paths_of_flow(file, result.flow);
  if (command.json) {
    const std::vector<std::string> none;
    print_for_machines(answer, is_flow ? used_arcs(file, result) : none, paths);
  } else {
    print_for_people(answer, paths);
  }
  if (verdict.refutation.empty()) return kWell;
  tell(one_line(fmt::format("mda-bench: {}: the answer of '{}' is wrong: {}", command.file,
                            code.name, verdict.refutation)) +
       "\n");
  return kWrongAnswer;
}

}  // namespace mda
