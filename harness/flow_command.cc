#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "algorithms/catalog.h"
#include "harness/clocks.h"
#include "harness/commands.h"
#include "harness/errors.h"
#include "harness/files.h"
#include "harness/flow_file.h"
#include "harness/flow_referee.h"
#include "harness/messages.h"

namespace mda {
namespace {

using Json = nlohmann::ordered_json;

const FlowCode& find_code(const std::string& name) {
  if (const FlowCode* const code = find_flow_code(name)) return *code;
  std::string names;
  for (const FlowCode& code : flow_codes()) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", code.name);
  }
  throw InputError(fmt::format("unknown flow code '{}': there are {}", name, names));
}

FlowVerdict judge(const FlowFile& file, const FlowResult& result, const std::string& path) {
  try {
    return judge_flow(file, result);
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

void print_for_people(const Json& answer) {
  for (const auto& [key, value] : answer.items()) {
    if (value.is_null()) continue;
    fmt::print("{:<16} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
}

}  // namespace

int flow(const FlowCommand& command) {
  const FlowCode& code = find_code(command.algorithm);
  const FlowFile file = parse_flow_file(read_file(command.file), command.file);
  const Stopwatch watch;
  const FlowResult result = code.solve(file.graph);
  const Elapsed elapsed{watch.wall_ms(), watch.cpu_ms()};
  if (result.outcome == FlowOutcome::kDeclined) {
    throw InputError(fmt::format("{}: '{}' declines: {}", command.file, code.name, result.reason));
  }
  const FlowVerdict verdict = judge(file, result, command.file);
  const Json answer = {{"algorithm", code.name},
                       {"nodes", file.graph.nodes},
                       {"arcs", file.graph.arcs.size()},
                       {"status", status_of(result, verdict)},
                       {"cost", or_null(verdict.cost)},
                       {"certified_bound", or_null(verdict.certified_bound)},
                       {"paths", or_null(verdict.paths)},
                       {"seconds", elapsed.wall_ms / 1e3},
                       {"cpu_seconds", elapsed.cpu_ms / 1e3}};
  if (command.json) {
    fmt::print("{}\n", answer.dump(2));
  } else {
    print_for_people(answer);
  }
  if (verdict.refutation.empty()) return kWell;
  tell(one_line(fmt::format("mda-bench: {}: the answer of '{}' is wrong: {}", command.file,
                            code.name, verdict.refutation)) +
       "\n");
  return kWrongAnswer;
}

}  // namespace mda
