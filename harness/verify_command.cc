#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "harness/commands.h"
#include "harness/errors.h"
#include "harness/run.h"
#include "harness/verify.h"

namespace mda {

int verify(const VerifyCommand& command, const std::atomic<bool>& interrupted) {
  const RunFiles files(command.directory);
  const Verification result = verify_run(files, worker_count(command.workers), interrupted);
  if (command.json) {
    const nlohmann::ordered_json json = {
        {"windows", result.windows},   {"rows", result.rows},
        {"scenes", result.scenes},     {"disagreements", result.disagreements},
        {"examples", result.examples}, {"torn_lines", files.torn()},
        {"outcome", files.outcome()}};
    fmt::print("{}\n", json.dump(2));
  } else {
    if (files.outcome() != "finished") {
      fmt::print("the run did not finish ({}): only what is there is checked\n", files.outcome());
    }
    for (const std::string& line : files.torn()) {
      fmt::print("{}: the last line is torn and was left out\n", line);
    }
    fmt::print("{} windows made anew, {} rows judged again: {}\n", result.windows, result.rows,
               result.disagreements == 0 ? "all as recorded"
                                         : fmt::format("{} disagreements", result.disagreements));
    if (files.has_scenes()) {
      fmt::print("scenes.jsonl, those of the open loop made anew and compared: {}\n",
                 result.scenes);
    }
    if (std::filesystem::exists(std::filesystem::path(command.directory) / "tracking.jsonl")) {
      fmt::print("tracking.jsonl, the closed loop, is not checked\n");
    }
    for (const std::string& example : result.examples) fmt::print("  {}\n", example);
  }
  if (interrupted) return kInterrupted;
  return result.disagreements == 0 ? kWell : kWrongAnswer;
}

}  // namespace mda
