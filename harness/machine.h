// The machine that times are taken on, and whether it is fit for that.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mda {

/// As the kernel tells it. What this system does not tell is empty.
struct MachineState {
  std::string cpu = "unknown";  ///< model name
  int cores = 0;                ///< logical processors; 0: not told
  std::string kernel;           ///< release
  std::string clock_source;
  std::optional<bool> smt;              ///< whether two threads share a core
  std::vector<std::string> governors;   ///< of frequency, each once
  std::optional<double> load_1min;      ///< mean number of runnable threads in the last minute
  std::optional<double> stalled_10s;    ///< % of the last 10 s in which a thread had to wait (PSI)
  std::optional<double> stalled_total;  ///< the same since the start, in seconds
  std::string valgrind;                 ///< path of the program
};

/// Reads /proc and /sys below `root`, and looks for valgrind in `path`, directories between colons.
[[nodiscard]] MachineState read_machine(const std::filesystem::path& root, std::string_view path);

/// Something that decides how far times can be trusted.
struct Finding {
  std::string what;
  std::string state;
  bool is_good = true;
  std::string change;  ///< what to do about it; empty if it is good
};

/// In a fixed order: cores, governor, SMT, load, pressure, clock source, valgrind.
[[nodiscard]] std::vector<Finding> findings(const MachineState& machine);

}  // namespace mda
