// What the environment may do to us. main() says one sentence and picks the exit code.
#pragma once

#include <stdexcept>

namespace mda {

/// Bad usage or input: exit code 2. The text names what and where.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The disk or file system failed while running: exit code 5.
class DiskError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum ExitCode : int {
  kWell = 0,
  kWrongAnswer = 1,
  kBadInput = 2,
  kCellsFailed = 3,
  kUnfitForTiming = 4,
  kDiskFailed = 5,
  kInterrupted = 130
};

}  // namespace mda
