// argv -> command -> exit code.

#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "harness/cli.h"
#include "harness/commands.h"
#include "harness/errors.h"
#include "harness/messages.h"

namespace mda {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

/// What the first signal says; a command sets it before it catches signals.
std::string_view stopping;

/// The first signal asks the command to stop; a second one ends the program at once. Only calls
/// that a signal handler may make.
extern "C" void on_signal(int /*signal*/) {
  if (interrupted.exchange(true)) _exit(kInterrupted);
  const int error = errno;
  static_cast<void>(!write(STDERR_FILENO, stopping.data(), stopping.size()));
  errno = error;
}

void catch_signals(std::string_view message) {
  stopping = message;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

/// While a run records, nobody who stops listening to its progress may end it.
class DeafToPipes {
 public:
  DeafToPipes() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  DeafToPipes(const DeafToPipes&) = delete;
  DeafToPipes& operator=(const DeafToPipes&) = delete;
  ~DeafToPipes() { std::signal(SIGPIPE, before_); }

 private:
  void (*before_)(int);
};

struct Execute {
  int operator()(const ListCommand& command) const { return list(command); }
  int operator()(const RunCommand& command) const {
    catch_signals(
        "\nmda-bench: interrupted: the solves under way are finished first, each within the time "
        "limit; a second Ctrl-C stops at once\n");
    const DeafToPipes deaf;
    return run(command, interrupted);
  }
  int operator()(const VerifyCommand& command) const {
    catch_signals("\nmda-bench: interrupted: a second Ctrl-C stops at once\n");
    return verify(command, interrupted);
  }
  int operator()(const ExportCommand& command) const { return export_window(command); }
  int operator()(const SolveCommand& command) const { return solve(command); }
  int operator()(const CertifyCommand& command) const { return certify(command); }
  int operator()(const FlowCommand& command) const { return flow(command); }
  int operator()(const DoctorCommand& command) const { return doctor(command); }
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
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a write that fails
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
    return mda::failed(mda::kCellsFailed, mda::plain_words(error).c_str());
  }
}
