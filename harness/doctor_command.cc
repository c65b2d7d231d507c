#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "harness/commands.h"
#include "harness/errors.h"
#include "harness/machine.h"

namespace mda {
namespace {

using Json = nlohmann::ordered_json;

template <typename Value>
Json value_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json json_of(const MachineState& machine, const std::vector<Finding>& found, bool is_fit) {
  Json list = Json::array();
  for (const Finding& finding : found) {
    list.push_back({{"what", finding.what},
                    {"state", finding.state},
                    {"good", finding.is_good},
                    {"change", text_or_null(finding.change)}});
  }
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"kernel", text_or_null(machine.kernel)},
          {"clock_source", text_or_null(machine.clock_source)},
          {"smt", value_or_null(machine.smt)},
          {"governors", machine.governors},
          {"load_1min", value_or_null(machine.load_1min)},
          {"stalled_10s_percent", value_or_null(machine.stalled_10s)},
          {"stalled_total_s", value_or_null(machine.stalled_total)},
          {"valgrind", text_or_null(machine.valgrind)},
          {"fit", is_fit},
          {"findings", list}};
}

void print_for_people(const MachineState& machine, const std::vector<Finding>& found, bool is_fit) {
  fmt::print("{}\n", machine.cpu);
  for (const Finding& finding : found) {
    fmt::print("{:<13} {:<5} {}\n", finding.what, finding.is_good ? "good" : "mind", finding.state);
    if (!finding.is_good) fmt::print("{:<20}{}\n", "", finding.change);
  }
  fmt::print("{}\n", is_fit ? "Fit for timing."
                            : "Not fit for timing by wall clock. scripts/nightly.sh bears it: it "
                              "compares CPU times of interleaved runs.");
}

}  // namespace

int doctor(const DoctorCommand& command) {
  const char* path = std::getenv("PATH");
  const MachineState machine = read_machine("/", path == nullptr ? "" : path);
  const std::vector<Finding> found = findings(machine);
  const bool is_fit =
      std::all_of(found.begin(), found.end(), [](const Finding& f) { return f.is_good; });
  if (command.json) {
    fmt::print("{}\n", json_of(machine, found, is_fit).dump(2));
  } else {
    print_for_people(machine, found, is_fit);
  }
  return is_fit ? kWell : kUnfitForTiming;
}

}  // namespace mda
