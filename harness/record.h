// The files of a run: its lines are appended cell by cell, manifest.json says what was run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

  /// Removes the last `bytes`, as far as the disk allows.
  void take_back(std::size_t bytes);

 private:
  std::string path_;
  int descriptor_ = -1;
  long long size_ = 0;
};

/// What a run writes lines of.
struct Contents {
  bool open = true;     ///< rows.jsonl and answers.jsonl
  bool closed = false;  ///< tracking.jsonl
  bool scenes = false;  ///< scenes.jsonl
};

/// Lines of a cell for the file of each name; none for a file that is not there.
struct NewLines {
  std::string_view rows = {};
  std::string_view answers = {};
  std::string_view tracking = {};
  std::string_view scenes = {};
};

/// The directory of a run. Not thread safe.
class RunDirectory {
 public:
  /// Makes the directory, parents included, and the empty files in it. Throws InputError if a run
  /// is already there or it cannot be made; then nothing is left behind.
  explicit RunDirectory(const std::filesystem::path& path, Contents contents = {});

  /// Takes back, as far as the disk allows, the files and the directories that were made. For a run
  /// that could not begin.
  void discard() noexcept;

  /// All the lines or, if the disk fails, none: throws DiskError. Those of rows.jsonl come last, so
  /// that no row is without what goes with it.
  void append(const NewLines& lines);
  /// Replaces the manifest. Throws DiskError.
  void write_manifest(std::string_view json) { write("manifest.json", json); }
  /// Writes trajectories.json. Throws DiskError.
  void write_trajectories(std::string_view json) { write("trajectories.json", json); }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void make_files(Contents contents);
  void write(const char* name, std::string_view json);

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  ///< directories, parents first
  std::optional<AppendFile> rows_;
  std::optional<AppendFile> answers_;
  std::optional<AppendFile> tracking_;
  std::optional<AppendFile> scenes_;
};

}  // namespace mda
