// Reads a run back: what its manifest says was run, and its lines, cell by cell.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "harness/sweep.h"

namespace mda {

/// Scenario, scan period, replicate, K.
using CellName = std::tuple<std::string, double, int, int>;

/// A line of a file, counted from 1.
struct FileLine {
  int number = 0;
  std::string_view text;
};

struct CellLines {
  std::vector<FileLine> rows;
  std::vector<FileLine> answers;
  std::vector<FileLine> scenes;  ///< of the open loop
  bool may_be_cut = false;  ///< it was the last to be written, and the end of that may be missing
};

/// The files of an open-loop run in memory.
class RunFiles {
 public:
  /// A last line that is torn, as an interrupted write leaves it, is left out. Throws InputError,
  /// naming file and place, if a file is absent, the manifest is not one of ours, or another line
  /// is not a JSON object with the fields that name a cell.
  explicit RunFiles(const std::filesystem::path& directory);
  RunFiles(const RunFiles&) = delete;
  RunFiles& operator=(const RunFiles&) = delete;

  /// What was asked for, with every parameter as the manifest has it.
  [[nodiscard]] const Sweep& sweep() const noexcept { return sweep_; }
  /// "finished", or how else the run ended.
  [[nodiscard]] const std::string& outcome() const noexcept { return outcome_; }
  /// Of the open loop.
  [[nodiscard]] int cells_failed() const noexcept { return cells_failed_; }
  /// The torn lines that were left out, as file:line.
  [[nodiscard]] const std::vector<std::string>& torn() const noexcept { return torn_; }
  /// Those with rows or answers.
  [[nodiscard]] const std::map<CellName, CellLines>& cells() const noexcept { return cells_; }
  /// Runs of older programs have no scenes.jsonl.
  [[nodiscard]] bool has_scenes() const noexcept { return has_scenes_; }

 private:
  void read_manifest(const std::string& file);
  /// Hands over every line, parsed, but for a last one that is torn.
  template <typename Take>
  void each_line(const std::string& file, const std::string& text, Take take);
  void index(const std::string& file, const std::string& text,
             std::vector<FileLine> CellLines::*lines);
  void read_scenes(const std::filesystem::path& path);
  void mark_the_last(std::vector<FileLine> CellLines::*lines);

  Sweep sweep_;
  std::string outcome_;
  int cells_failed_ = 0;
  std::string rows_;
  std::string answers_;
  std::string scenes_;
  bool has_scenes_ = false;
  std::vector<std::string> torn_;
  std::map<CellName, CellLines> cells_;
};

}  // namespace mda
