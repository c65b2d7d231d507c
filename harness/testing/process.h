// Other programs, started by tests: mda-bench itself, and solvers that read its files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mda::testing {

/// Where a program's output goes; an empty name closes the stream.
struct Streams {
  std::string out = "/dev/null";
  std::string err = "/dev/null";
};

class Process {
 public:
  /// Starts arguments[0], looked up along PATH, in `directory`, which file names are relative to.
  /// Throws std::system_error if it cannot.
  Process(const std::vector<std::string>& arguments, const std::string& directory,
          const Streams& streams);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  /// Ends it if it still runs.
  ~Process();

  void send(int signal) const;
  /// Its exit code, or 128 + the number of the signal that ended it, as a shell tells it.
  int wait();

 private:
  int id_ = 0;
};

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

/// Runs a program to its end in `directory` and keeps what it said.
[[nodiscard]] Outcome run_program(const std::vector<std::string>& arguments,
                                  const std::string& directory);

/// Whether there is such a program along PATH.
[[nodiscard]] bool is_installed(std::string_view program);

}  // namespace mda::testing
