#include "harness/record.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>
#include <vector>

#include "harness/errors.h"
#include "harness/files.h"

namespace mda {
namespace {

constexpr std::array kFileNames = {"rows.jsonl",   "answers.jsonl", "tracking.jsonl",
                                   "scenes.jsonl", "manifest.json", "trajectories.json"};

void remove_directories(std::vector<std::filesystem::path>& directories) noexcept {
  for (std::error_code ignored; !directories.empty(); directories.pop_back()) {
    std::filesystem::remove(directories.back(), ignored);
  }
}

/// Makes the directory and its parents; returns those that it made, none if it fails.
std::vector<std::filesystem::path> make_directory(const std::filesystem::path& path,
                                                  std::error_code& error) {
  std::vector<std::filesystem::path> made;
  std::filesystem::path directory;
  for (const std::filesystem::path& name : path) {
    directory /= name;
    if (std::filesystem::create_directory(directory, error)) made.push_back(directory);
    if (!error) continue;
    remove_directories(made);
    return made;
  }
  return made;
}

std::vector<std::filesystem::path> made_for_run(const std::filesystem::path& path) {
  std::error_code error;
  auto made = make_directory(path, error);
  if (error) {
    throw InputError(
        fmt::format("cannot make the directory '{}': {}", path.string(), error.message()));
  }
  for (const char* name : kFileNames) {
    if (!std::filesystem::exists(path / name, error)) continue;
    throw InputError(
        fmt::format("'{}' holds a run already ({}): name another directory", path.string(), name));
  }
  return made;
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

RunDirectory::RunDirectory(const std::filesystem::path& path, Contents contents)
    : path_(path), made_(made_for_run(path)) {
  try {
    make_files(contents);
  } catch (const InputError&) {
    discard();
    throw;
  }
}

void RunDirectory::make_files(Contents contents) {
  if (contents.open) {
    rows_.emplace((path_ / "rows.jsonl").string());
    answers_.emplace((path_ / "answers.jsonl").string());
  }
  if (contents.closed) tracking_.emplace((path_ / "tracking.jsonl").string());
  if (contents.scenes) scenes_.emplace((path_ / "scenes.jsonl").string());
}

void RunDirectory::discard() noexcept {
  std::error_code ignored;
  if (rows_) std::filesystem::remove(path_ / "rows.jsonl", ignored);
  if (answers_) std::filesystem::remove(path_ / "answers.jsonl", ignored);
  if (tracking_) std::filesystem::remove(path_ / "tracking.jsonl", ignored);
  if (scenes_) std::filesystem::remove(path_ / "scenes.jsonl", ignored);
  std::filesystem::remove(path_ / "manifest.json", ignored);
  std::filesystem::remove(path_ / "trajectories.json", ignored);
  remove_directories(made_);
}

void RunDirectory::append(const NewLines& lines) {
  std::vector<std::pair<AppendFile*, std::size_t>> done;
  const auto add = [&](std::optional<AppendFile>& file, std::string_view text) {
    if (text.empty()) return;
    file.value().append(text);
    done.emplace_back(&*file, text.size());
  };
  try {
    add(scenes_, lines.scenes);
    add(tracking_, lines.tracking);
    add(answers_, lines.answers);
    add(rows_, lines.rows);
  } catch (const DiskError&) {
    for (const auto& [file, bytes] : done) file->take_back(bytes);
    throw;
  }
}

void RunDirectory::write(const char* name, std::string_view json) {
  try {
    write_file((path_ / name).string(), json);
  } catch (const InputError& error) {  // the directory was fine when the run began
    throw DiskError(error.what());
  }
}

}  // namespace mda
