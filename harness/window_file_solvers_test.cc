// Exported windows mean the same to solvers that we did not write.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/random_problems.h"
#include "harness/files.h"
#include "harness/referee.h"
#include "harness/testing/process.h"
#include "harness/testing/real_windows.h"
#include "harness/testing/temporary_directory.h"
#include "harness/window_file.h"

namespace mda::testing {
namespace {

/// At least 100 windows of all groups: several widths, scan periods and draws, and scans from the
/// first to the last.
const std::vector<AssociationProblem>& exported_windows() {
  static const std::vector<AssociationProblem> kWindows = [] {
    std::vector<AssociationProblem> all;
    const auto add = [&all](const WindowSource& source, int step) {
      for (AssociationProblem& problem : real_windows(source, step)) {
        all.push_back(std::move(problem));
      }
    };
    for (const char* scenario : {"A", "B", "C"}) {
      add({scenario, 3, 8.0, 1}, 2);
      add({scenario, 5, 4.0, 2}, 3);
      add({scenario, 7, 8.0, 3}, 5);
    }
    add({"D", 3, 8.0, 1}, 5);
    add({"D", 3, 2.0, 2}, 3);
    add({"D", 1, 8.0, 3}, 3);
    return all;
  }();
  return kWindows;
}

/// Two random problems with exactly-once rows for every real window without any.
std::vector<AssociationProblem> problems_with_equality_rows() {
  std::vector<AssociationProblem> all;
  RandomShape shape;
  shape.exactly_once = 0.4;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) all.push_back(random_problem(shape, seed));
  return all;
}

double optimum_of(const AssociationProblem& problem) {
  const Solution solution = find_algorithm("exact")->make()->solve(problem, Budget{});
  EXPECT_EQ(solution.status, Status::kOptimal);
  return examine(problem, solution.x).cost;
}

/// The optimum that glpsol claims of a file, of a format that `option` names.
std::optional<double> glpsol(const TemporaryDirectory& directory, const char* option,
                             const std::string& text) {
  write_file(directory.file("window"), text);
  const Outcome outcome =
      run_program({"glpsol", option, "window", "-w", "solution"}, directory.path().string());
  if (outcome.code != 0) return std::nullopt;
  // "s mip <rows> <columns> o <objective>", where "o" stands for optimal.
  std::istringstream lines(read_file(directory.file("solution")));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string letter, kind, rows, columns, status;
    double objective = 0.0;
    if (words >> letter >> kind >> rows >> columns >> status >> objective && letter == "s") {
      return status == "o" ? std::optional(objective) : std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<double> lp_solve(const TemporaryDirectory& directory, const std::string& text) {
  write_file(directory.file("window"), text);
  const Outcome outcome =
      run_program({"lp_solve", "-fmps", "window", "-S3"}, directory.path().string());
  const std::string label = "Value of objective function:";
  const auto found = outcome.out.find(label);
  if (found == std::string::npos) return std::nullopt;
  return std::stod(outcome.out.substr(found + label.size()));
}

/// Both round what they print.
void expect_same_optimum(const std::optional<double>& theirs, double ours) {
  ASSERT_TRUE(theirs) << "no optimum";
  EXPECT_NEAR(*theirs, ours, 1e-6 * std::max(1.0, std::abs(ours)));
}

TEST(WindowFileSolversTest, AtLeast100WindowsAreExported) {
  EXPECT_GE(exported_windows().size(), 100U);
}

TEST(WindowFileSolversTest, GlpsolFindsTheSameOptimaInMps) {
  if (!is_installed("glpsol")) GTEST_SKIP() << "the program glpsol is not installed";
  const TemporaryDirectory directory;
  for (const AssociationProblem& problem : exported_windows()) {
    expect_same_optimum(glpsol(directory, "--freemps", window_mps(problem)), optimum_of(problem));
  }
  for (const AssociationProblem& problem : problems_with_equality_rows()) {
    expect_same_optimum(glpsol(directory, "--freemps", window_mps(problem)), optimum_of(problem));
  }
}

TEST(WindowFileSolversTest, LpSolveFindsTheSameOptimaInMps) {
  if (!is_installed("lp_solve")) GTEST_SKIP() << "the program lp_solve is not installed";
  const TemporaryDirectory directory;
  for (const AssociationProblem& problem : exported_windows()) {
    expect_same_optimum(lp_solve(directory, window_mps(problem)), optimum_of(problem));
  }
  for (const AssociationProblem& problem : problems_with_equality_rows()) {
    expect_same_optimum(lp_solve(directory, window_mps(problem)), optimum_of(problem));
  }
}

TEST(WindowFileSolversTest, GlpsolFindsTheSameOptimaInTheLpFormat) {
  if (!is_installed("glpsol")) GTEST_SKIP() << "the program glpsol is not installed";
  const TemporaryDirectory directory;
  for (std::size_t i = 0; i < exported_windows().size(); i += 7) {
    const AssociationProblem& problem = exported_windows()[i];
    expect_same_optimum(glpsol(directory, "--lp", window_lp(problem)), optimum_of(problem));
  }
  for (const AssociationProblem& problem : problems_with_equality_rows()) {
    expect_same_optimum(glpsol(directory, "--lp", window_lp(problem)), optimum_of(problem));
  }
}

}  // namespace
}  // namespace mda::testing
