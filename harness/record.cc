#include "harness/record.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <vector>

#include "harness/errors.h"
#include "harness/files.h"

namespace mda {
namespace {

/// Makes the directory and its parents; takes back those that it made if it fails.
std::error_code make_directory(const std::filesystem::path& path) {
  std::error_code error;
  std::vector<std::filesystem::path> made;
  std::filesystem::path directory;
  for (const std::filesystem::path& name : path) {
    directory /= name;
    if (std::filesystem::create_directory(directory, error)) made.push_back(directory);
    if (!error) continue;
    for (std::error_code ignored; !made.empty(); made.pop_back()) {
      std::filesystem::remove(made.back(), ignored);
    }
    return error;
  }
  return error;
}

std::filesystem::path made_directory(const std::filesystem::path& path) {
  std::error_code error = make_directory(path);
  if (error) {
    throw InputError(
        fmt::format("cannot make the directory '{}': {}", path.string(), error.message()));
  }
  for (const char* name : {"rows.jsonl", "answers.jsonl", "tracking.jsonl", "manifest.json"}) {
    if (!std::filesystem::exists(path / name, error)) continue;
    throw InputError(
        fmt::format("'{}' holds a run already ({}): name another directory", path.string(), name));
  }
  return path;
}

}  // namespace

AppendFile::AppendFile(std::string path) : path_(std::move(path)) {
  descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor_ < 0) {
    throw InputError(fmt::format("cannot make '{}': {}", path_, std::strerror(errno)));
  }
}

AppendFile::~AppendFile() { close(descriptor_); }

void AppendFile::append(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const std::string why = std::strerror(errno);
      const bool taken_back = ftruncate(descriptor_, size_) == 0;
      throw DiskError(fmt::format("cannot write '{}': {}{}", path_, why,
                                  taken_back ? "" : "; its last line may be torn"));
    }
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  size_ = lseek(descriptor_, 0, SEEK_END);
}

void AppendFile::take_back(std::size_t bytes) {
  if (ftruncate(descriptor_, size_ - static_cast<long long>(bytes)) != 0) return;
  size_ -= static_cast<long long>(bytes);
}

RunDirectory::RunDirectory(const std::filesystem::path& path, Loops loops)
    : path_(made_directory(path)) {
  if (loops.open) {
    rows_.emplace((path / "rows.jsonl").string());
    answers_.emplace((path / "answers.jsonl").string());
  }
  if (loops.closed) tracking_.emplace((path / "tracking.jsonl").string());
}

void RunDirectory::append(std::string_view rows, std::string_view answers) {
  answers_->append(answers);
  try {
    rows_->append(rows);
  } catch (const DiskError&) {
    answers_->take_back(answers.size());  // answers without rows are no use
    throw;
  }
}

void RunDirectory::append_tracking(std::string_view lines) { tracking_->append(lines); }

void RunDirectory::write_manifest(std::string_view json) {
  try {
    write_file((path_ / "manifest.json").string(), json);
  } catch (const InputError& error) {  // the directory was fine when the run began
    throw DiskError(error.what());
  }
}

}  // namespace mda
