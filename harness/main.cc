// argv -> command -> exit code.

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>

#include "harness/cli.h"
#include "harness/commands.h"
#include "harness/errors.h"

namespace mda {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

/// The first signal asks the run to stop; a second one ends the program at once.
extern "C" void on_signal(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

struct Execute {
  int operator()(const ListCommand& command) const { return list(command); }
  int operator()(const RunCommand& command) const {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    return run(command, interrupted);
  }
  int operator()(const ExportCommand& command) const { return export_window(command); }
  int operator()(const SolveCommand& command) const { return solve(command); }
};

int main_or_throw(int argc, const char* const* argv) {
  const auto command = parse_command_line(argc, argv);
  return command ? std::visit(Execute{}, *command) : kWell;
}

}  // namespace
}  // namespace mda

int main(int argc, char** argv) {
  try {
    const int code = mda::main_or_throw(argc, argv);
    if (std::fflush(stdout) != 0) throw mda::DiskError("cannot write to standard output");
    return code;
  } catch (const mda::InputError& error) {
    fmt::print(stderr, "mda-bench: {}\n", error.what());
    return mda::kBadInput;
  } catch (const mda::DiskError& error) {
    fmt::print(stderr, "mda-bench: {}\n", error.what());
    return mda::kDiskFailed;
  } catch (const std::exception& error) {
    fmt::print(stderr, "mda-bench: {}\n", error.what());
    return mda::kCellsFailed;
  }
}
