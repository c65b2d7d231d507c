// The program that is tested, in a directory of its own. MDA_BENCH is its path.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "harness/errors.h"
#include "harness/testing/bench_program.h"

namespace mda::testing {

using Words = std::vector<std::string>;

class ProgramTest : public ::testing::Test {
 protected:
  [[nodiscard]] Outcome bench(const Words& words) const { return program_.run(words); }
  [[nodiscard]] std::string file(const std::string& name) const { return program_.file(name); }

  /// Exit code 2, nothing on stdout, one line on stderr, and no file that was not there.
  void expect_refused(const Words& words) const {
    const auto files = listing();
    const Outcome outcome = bench(words);
    std::string shown;
    for (const std::string& word : words) shown += word + " ";
    EXPECT_EQ(outcome.code, kBadInput) << shown;
    EXPECT_EQ(outcome.out, "") << shown;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err << shown;
    EXPECT_TRUE(outcome.err.starts_with("mda-bench: ")) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with("\n")) << outcome.err;
    EXPECT_EQ(listing(), files) << shown;
  }

  BenchProgram program_{MDA_BENCH};

 private:
  [[nodiscard]] std::vector<std::string> listing() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(file("."))) {
      names.push_back(entry.path().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
};

}  // namespace mda::testing
