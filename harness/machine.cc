#include "harness/machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace mda {
namespace {

namespace fs = std::filesystem;

/// The rest of the line of `file` that begins with `start`, without what surrounds it.
std::string value_after(const fs::path& file, std::string_view start) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(start)) continue;
    const auto first = line.find_first_not_of(" \t:", start.size());
    return first == std::string::npos ? "" : line.substr(first);
  }
  return "";
}

std::optional<double> number(const std::string& text) {
  std::istringstream stream(text);
  double value = 0.0;
  return stream >> value ? std::optional(value) : std::nullopt;
}

/// The number behind `name` in "some avg10=1.5 avg60=... total=123".
std::optional<double> pressure(const fs::path& root, const std::string& name) {
  const std::string line = value_after(root / "proc/pressure/cpu", "some");
  const auto place = line.find(name + "=");
  return place == std::string::npos ? std::nullopt : number(line.substr(place + name.size() + 1));
}

int count_cores(const fs::path& root) {
  std::ifstream stream(root / "proc/cpuinfo");
  int cores = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("processor")) ++cores;
  }
  return cores;
}

std::vector<std::string> governors_of(const fs::path& root, int cores) {
  std::vector<std::string> found;
  for (int core = 0; core < cores; ++core) {
    const std::string file =
        fmt::format("sys/devices/system/cpu/cpu{}/cpufreq/scaling_governor", core);
    const std::string governor = value_after(root / file, "");
    const bool is_new = std::find(found.begin(), found.end(), governor) == found.end();
    if (!governor.empty() && is_new) found.push_back(governor);
  }
  return found;
}

std::string program(const std::string& name, std::string_view path) {
  std::istringstream directories{std::string(path)};
  for (std::string directory; std::getline(directories, directory, ':');) {
    std::error_code ignored;
    const fs::path file = fs::path(directory) / name;
    if (fs::is_regular_file(file, ignored)) return file.string();
  }
  return "";
}

Finding good(std::string what, std::string state) {
  return {std::move(what), std::move(state), true, ""};
}

Finding bad(std::string what, std::string state, std::string change) {
  return {std::move(what), std::move(state), false, std::move(change)};
}

Finding cores_finding(const MachineState& machine) {
  const std::string state = fmt::format("{}", machine.cores);
  if (machine.cores >= 2) return good("cores", state);
  return bad("cores", state, "use a machine with two or more: the system itself needs one");
}

Finding governor_finding(const MachineState& machine) {
  if (machine.governors.empty()) {
    return good("governor", "not told: the frequency is not in this system's hands");
  }
  const std::string state = fmt::format("{}", fmt::join(machine.governors, ", "));
  if (state == "performance") return good("governor", state);
  return bad("governor", state, "cpupower frequency-set -g performance");
}

Finding smt_finding(const MachineState& machine) {
  if (!machine.smt) return good("SMT", "not told");
  if (!*machine.smt) return good("SMT", "off");
  return bad("SMT", "on", "echo off > /sys/devices/system/cpu/smt/control");
}

Finding load_finding(const MachineState& machine) {
  if (!machine.load_1min) return good("load", "not told");
  const std::string state = fmt::format("{:.2f} in the last minute", *machine.load_1min);
  if (*machine.load_1min < 0.5 * std::max(1, machine.cores)) return good("load", state);
  return bad("load", state, "stop what else is running, or wait; CPU times suffer least");
}

Finding pressure_finding(const MachineState& machine) {
  if (!machine.stalled_10s) {
    return bad("pressure", "not told", "boot with psi=1: /proc/pressure/cpu marks spoilt samples");
  }
  const std::string state = fmt::format("{:.1f} % of the last 10 s", *machine.stalled_10s);
  if (*machine.stalled_10s <= 2.0) return good("pressure", state);
  return bad("pressure", state, "stop what else is running: wall times are worth nothing now");
}

Finding clock_finding(const MachineState& machine) {
  const std::string& clock = machine.clock_source;
  if (clock.empty()) return good("clock source", "not told");
  if (clock != "hpet" && clock != "acpi_pm" && clock != "jiffies") {
    return good("clock source", clock);
  }
  return bad("clock source", clock, "boot with clocksource=tsc: reading this one is slow");
}

Finding valgrind_finding(const MachineState& machine) {
  if (!machine.valgrind.empty()) return good("valgrind", machine.valgrind);
  return bad("valgrind", "not there", "apt-get install valgrind: it counts instructions");
}

}  // namespace

MachineState read_machine(const fs::path& root, std::string_view path) {
  MachineState machine;
  const std::string cpu = value_after(root / "proc/cpuinfo", "model name");
  if (!cpu.empty()) machine.cpu = cpu;
  machine.cores = count_cores(root);
  machine.kernel = value_after(root / "proc/sys/kernel/osrelease", "");
  machine.clock_source =
      value_after(root / "sys/devices/system/clocksource/clocksource0/current_clocksource", "");
  if (const auto smt = number(value_after(root / "sys/devices/system/cpu/smt/active", ""))) {
    machine.smt = *smt != 0.0;
  }
  machine.governors = governors_of(root, machine.cores);
  machine.load_1min = number(value_after(root / "proc/loadavg", ""));
  machine.stalled_10s = pressure(root, "avg10");
  machine.stalled_total = pressure(root, "total");
  if (machine.stalled_total) *machine.stalled_total *= 1e-6;
  machine.valgrind = program("valgrind", path);
  return machine;
}

std::vector<Finding> findings(const MachineState& machine) {
  return {cores_finding(machine),   governor_finding(machine), smt_finding(machine),
          load_finding(machine),    pressure_finding(machine), clock_finding(machine),
          valgrind_finding(machine)};
}

}  // namespace mda
