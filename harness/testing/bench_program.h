// mda-bench in a directory of its own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "harness/testing/process.h"
#include "harness/testing/temporary_directory.h"

namespace mda::testing {

class BenchProgram {
 public:
  /// `path`: of the program.
  explicit BenchProgram(std::string path) : path_(std::move(path)) {}

  /// `words`: the command line, where file names are relative to the directory.
  [[nodiscard]] Outcome run(const std::vector<std::string>& words) const;
  /// The exit code only.
  [[nodiscard]] int run(const std::vector<std::string>& words, const Streams& streams) const;
  [[nodiscard]] std::unique_ptr<Process> start(const std::vector<std::string>& words,
                                               const Streams& streams) const;

  /// Waits until the file has text; false if it still has none after a minute.
  [[nodiscard]] bool wait_for_text(const std::string& name) const;

  [[nodiscard]] std::string file(const std::string& name) const { return directory_.file(name); }

 private:
  [[nodiscard]] std::vector<std::string> command(const std::vector<std::string>& words) const;

  std::string path_;
  TemporaryDirectory directory_;
};

}  // namespace mda::testing
