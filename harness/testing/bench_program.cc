#include "harness/testing/bench_program.h"

#include <chrono>
#include <system_error>
#include <thread>

namespace mda::testing {

std::vector<std::string> BenchProgram::command(const std::vector<std::string>& words) const {
  std::vector<std::string> all = {path_};
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

Outcome BenchProgram::run(const std::vector<std::string>& words) const {
  return run_program(command(words), directory_.path().string());
}

int BenchProgram::run(const std::vector<std::string>& words, const Streams& streams) const {
  return start(words, streams)->wait();
}

std::unique_ptr<Process> BenchProgram::start(const std::vector<std::string>& words,
                                             const Streams& streams) const {
  return std::make_unique<Process>(command(words), directory_.path().string(), streams);
}

bool BenchProgram::wait_for_text(const std::string& name) const {
  using Clock = std::chrono::steady_clock;
  for (const auto end = Clock::now() + std::chrono::minutes(1); Clock::now() < end;) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file(name), error);
    if (!error && size > 0) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

}  // namespace mda::testing
