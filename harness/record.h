// The files of a run: rows.jsonl and answers.jsonl grow cell by cell, manifest.json says what was
// run.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace mda {

/// An append-only file: a text is there as a whole or, if the disk fails, not at all.
class AppendFile {
 public:
  /// Makes a new file. Throws InputError if it exists already or cannot be made.
  explicit AppendFile(std::string path);
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;
  ~AppendFile();

  /// Throws DiskError after taking back what was written of `text`.
  void append(std::string_view text);

 private:
  std::string path_;
  int descriptor_ = -1;
  long long size_ = 0;
};

/// The directory of a run. Not thread safe.
class RunDirectory {
 public:
  /// Makes the directory, parents included, and the empty files in it. Throws InputError if a run
  /// is already there or it cannot be made; then nothing is left behind.
  explicit RunDirectory(const std::filesystem::path& path);

  void append(std::string_view rows, std::string_view answers);
  /// Replaces the manifest. Throws DiskError.
  void write_manifest(std::string_view json);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  AppendFile rows_;
  AppendFile answers_;
};

}  // namespace mda
