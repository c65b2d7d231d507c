#include "harness/testing/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "harness/files.h"
#include "harness/testing/temporary_directory.h"

namespace mda::testing {
namespace {

void direct(posix_spawn_file_actions_t& actions, int descriptor, const std::string& name) {
  if (name.empty()) {
    posix_spawn_file_actions_addclose(&actions, descriptor);
  } else {
    posix_spawn_file_actions_addopen(&actions, descriptor, name.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0644);
  }
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const std::string& directory,
                 const Streams& streams) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  direct(actions, STDOUT_FILENO, streams.out);
  direct(actions, STDERR_FILENO, streams.err);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  const int error = posix_spawnp(&id_, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), arguments[0]);
}

Process::~Process() {
  if (id_ == 0) return;
  send(SIGKILL);
  wait();
}

void Process::send(int signal) const { kill(id_, signal); }

int Process::wait() {
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Outcome run_program(const std::vector<std::string>& arguments, const std::string& directory) {
  const TemporaryDirectory kept;
  const Streams streams = {kept.file("out"), kept.file("err")};
  Outcome outcome;
  outcome.code = Process(arguments, directory, streams).wait();
  outcome.out = read_file(streams.out);
  outcome.err = read_file(streams.err);
  return outcome;
}

bool is_installed(std::string_view program) {
  const char* path = std::getenv("PATH");
  std::istringstream directories(path == nullptr ? "" : path);
  for (std::string directory; std::getline(directories, directory, ':');) {
    const std::string file = (std::filesystem::path(directory) / program).string();
    if (access(file.c_str(), X_OK) == 0) return true;
  }
  return false;
}

}  // namespace mda::testing
