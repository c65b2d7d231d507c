// A recorded run that may be tampered with.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/sweep.h"
#include "harness/testing/temporary_directory.h"
#include "harness/verify.h"

namespace mda::testing {

/// Every test has a copy of its own.
class TamperedRun : public ::testing::Test {
 protected:
  /// `original`: the directory of the run.
  explicit TamperedRun(std::filesystem::path original) : original_(std::move(original)) {
    restore();
  }

  /// Undoes all tampering.
  void restore() const;

  [[nodiscard]] std::filesystem::path path() const { return directory_.path() / "run"; }

  [[nodiscard]] Verification verify(int workers = 2) const;

  /// Changes one line of a file, as JSON; the first for which `change` returns true. A line that
  /// becomes null goes away.
  void tamper(const std::string& name, const std::function<bool(nlohmann::json&)>& change) const;

  /// Replaces a text that is in the manifest.
  void change_manifest(const std::string& text, const std::string& by) const;

  /// The sentence of one of the first disagreements has `with` in it.
  void expect_disagreement(const std::string& with) const;

 private:
  std::filesystem::path original_;
  TemporaryDirectory directory_;
};

/// The directory of a run of the sweep, which goes away when the program ends.
[[nodiscard]] std::filesystem::path kept_run(const Sweep& sweep);

}  // namespace mda::testing
