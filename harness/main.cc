// argv -> command -> exit code.

#include <fcntl.h>
#include <malloc.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "harness/cli.h"
#include "harness/commands.h"
#include "harness/errors.h"
#include "harness/messages.h"

namespace mda {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

/// The first signal asks the run to stop; a second one ends the program at once.
extern "C" void on_signal(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

void catch_signals() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

struct Execute {
  int operator()(const ListCommand& command) const { return list(command); }
  int operator()(const RunCommand& command) const {
    catch_signals();
    return run(command, interrupted);
  }
  int operator()(const VerifyCommand& command) const {
    catch_signals();
    return verify(command, interrupted);
  }
  int operator()(const ExportCommand& command) const { return export_window(command); }
  int operator()(const SolveCommand& command) const { return solve(command); }
  int operator()(const FlowCommand& command) const { return flow(command); }
};

/// A standard stream that the caller closed leaves its number to the next file that is opened,
/// which would then hold what is printed. Occupied for reading only, so that writing still fails.
void occupy_closed_streams() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) < 0) open("/dev/null", O_RDONLY);
  }
}

int failed(ExitCode code, const char* why) {
  tell("mda-bench: " + one_line(why) + "\n");
  return code;
}

int main_or_throw(int argc, const char* const* argv) {
  const auto command = parse_command_line(argc, argv);
  return command ? std::visit(Execute{}, *command) : kWell;
}

}  // namespace
}  // namespace mda

int main(int argc, char** argv) {
  // The allocator would give a worker's memory back to the system after every cell and fetch it
  // again for the next, page fault by page fault: a tenth of a run's time.
  mallopt(M_TOP_PAD, 64 << 20);
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // nor should a large array be new pages every time
  mda::occupy_closed_streams();
  try {
    const int code = mda::main_or_throw(argc, argv);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw mda::DiskError("cannot write to standard output");
    }
    return code;
  } catch (const mda::InputError& error) {
    return mda::failed(mda::kBadInput, error.what());
  } catch (const mda::DiskError& error) {
    return mda::failed(mda::kDiskFailed, error.what());
  } catch (const std::system_error& error) {
    // fmt::print throws it when stdout, which is all it prints to, takes no more.
    const std::string why = error.code().message();
    return mda::failed(mda::kDiskFailed, ("cannot write to standard output: " + why).c_str());
  } catch (const std::bad_alloc&) {
    return mda::failed(mda::kCellsFailed, "there is not enough memory for this");
  } catch (const std::exception& error) {
    return mda::failed(mda::kCellsFailed, error.what());
  }
}
