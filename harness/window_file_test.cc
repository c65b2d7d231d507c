#include "harness/window_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "algorithms/testing/draw.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/tiny_problems.h"
#include "harness/errors.h"

namespace mda::testing {
namespace {

AssociationProblem problem_of(std::uint64_t seed) {
  return random_problem(random_shape(seed, 40), seed);
}

RC_GTEST_PROP(WindowFileTest, JsonGivesTheSameProblemBack, (std::uint64_t seed)) {
  const AssociationProblem problem = problem_of(seed);
  const AssociationProblem back = parse_window(window_json(problem, {{"seed", seed}}), "w.json");
  RC_ASSERT(back.fingerprint() == problem.fingerprint());
  RC_ASSERT(back.shape().dimensions == problem.shape().dimensions);
  for (int j = 0; j < problem.columns(); ++j) RC_ASSERT(back.cost(j) == problem.cost(j));
}

TEST(WindowFileTest, JsonTakesTinyProblemsToo) {
  for (const TinyProblem& tiny : tiny_problems()) {
    const AssociationProblem back = parse_window(window_json(tiny.problem, {}), "w.json");
    EXPECT_EQ(back.fingerprint(), tiny.problem.fingerprint()) << tiny.name;
  }
}

TEST(WindowFileTest, ReadsTheContractsExample) {
  const AssociationProblem problem = parse_window(
      R"({"schema": 1, "rows": [{"dimension": 0, "use": "at-most-once"},
                                {"dimension": 2, "use": "exactly-once"}],
          "columns": [{"cost": -3.2, "rows": [1, 0]}, {"cost": 4, "rows": [1]}],
          "provenance": {"anything": [1, 2]}})",
      "w.json");
  EXPECT_EQ(problem.rows(), 2);
  EXPECT_EQ(problem.columns(), 2);
  EXPECT_EQ(problem.shape().dimensions, 2);
  EXPECT_EQ(problem.use(0), RowUse::kAtMostOnce);
  EXPECT_EQ(problem.use(1), RowUse::kExactlyOnce);
  EXPECT_EQ(problem.cost(0), -3.2);
  EXPECT_EQ(problem.rows_of(0)[0], 0);
  EXPECT_EQ(problem.rows_of(0)[1], 1);
}

struct Malformed {
  std::string text;
  const char* place;  ///< what the message must name, beside the file
};

std::string window(const std::string& rows, const std::string& columns) {
  return R"({"schema": 1, "rows": [)" + rows + R"(], "columns": [)" + columns + "]}";
}

/// A window of two good rows and one column that is `column`.
Malformed bad_column(const std::string& column, const char* place) {
  const std::string row = R"({"dimension": 1, "use": "at-most-once"})";
  const std::string other = R"({"dimension": 2, "use": "at-most-once"})";
  return {window(row + "," + other + "," + row, column), place};
}

Malformed bad_row(const std::string& row, const char* place) { return {window(row, ""), place}; }

std::vector<Malformed> malformed_windows() {
  std::vector<Malformed> list = {
      {"", "line 1"},
      {"{", "line 1"},
      {"{\"schema\": 1,\n\"rows\": [}", "line 2"},
      {"hello", "line 1"},
      {std::string("\0\0\0", 3), "line 1"},
      {"\xff\xfe", "line 1"},
      {"[]", "object"},
      {"1", "object"},
      {"null", "object"},
      {"{}", "'schema'"},
      {R"({"schema": 2, "rows": [], "columns": []})", "'schema'"},
      {R"({"schema": "1", "rows": [], "columns": []})", "'schema'"},
      {R"({"schema": 1.0, "rows": [], "columns": []})", "'schema'"},
      {R"({"schema": 1, "columns": []})", "'rows'"},
      {R"({"schema": 1, "rows": []})", "'columns'"},
      {R"({"schema": 1, "rows": {}, "columns": []})", "'rows'"},
      {R"({"schema": 1, "rows": [], "columns": 3})", "'columns'"},
      {R"({"schema": 1, "rows": [], "columns": [], "dimensions": -1})", "'dimensions'"},
      {R"({"schema": 1, "rows": [], "columns": [], "dimensions": 1e9})", "'dimensions'"},
      {R"({"schema": 1, "rows": [], "columns": [], "dimensions": "3"})", "'dimensions'"},
      {R"({"schema": 1, "rows": [{"dimension": 7, "use": "at-most-once"}], "columns": [],
           "dimensions": 2})",
       "rows[0]: its dimension 7"},
      {R"({"schema": 1, "rows": [{"dimension": 0, "use": "at-most-once"},
                                 {"dimension": 1, "use": "at-most-once"}], "columns": [],
           "dimensions": 1})",
       "rows[1]: its dimension 1"},
      {R"({"schema": 1, "rows": [], "columns": [], "rows": []})", "'rows' is there twice"},
      {R"({"schema": 1, "rows": [], "columns": [], "cost": 1})", "unknown key 'cost'"},
      bad_row(R"({"dimension": 1, "use": "at-most-once", "dimension": 2})",
              "rows[0]: 'dimension' is there twice"),
      bad_row(R"({"dimension": 1, "use": "at-most-once", "name": "x"})",
              "rows[0]: unknown key 'name'"),
      bad_column(R"({"cost": -1, "rows": [0], "cost": -2})", "columns[0]: 'cost' is there twice"),
      bad_column(R"({"cost": -1, "rows": [0], "Cost": -2})", "columns[0]: unknown key 'Cost'"),
      bad_row("3", "rows[0]"),
      bad_row("{}", "rows[0]: 'dimension'"),
      bad_row(R"({"dimension": 1})", "rows[0]: 'use'"),
      bad_row(R"({"dimension": "1", "use": "at-most-once"})", "rows[0]: 'dimension'"),
      bad_row(R"({"dimension": 1.5, "use": "at-most-once"})", "rows[0]: 'dimension'"),
      bad_row(R"({"dimension": true, "use": "at-most-once"})", "rows[0]: 'dimension'"),
      bad_row(R"({"dimension": 1, "use": "twice"})", "rows[0]: 'use'"),
      bad_row(R"({"dimension": 1, "use": 1})", "rows[0]: 'use'"),
      bad_row(R"({"dimension": -1, "use": "at-most-once"})", "row 0"),
      bad_row(R"({"dimension": 2147483648, "use": "at-most-once"})", "rows[0]: 'dimension'"),
      bad_row(R"({"dimension": 18446744073709551615, "use": "at-most-once"})",
              "rows[0]: 'dimension'"),
      bad_row(R"({"dimension": 99999999999999999999999, "use": "at-most-once"})",
              "rows[0]: 'dimension'"),
      bad_column("[]", "columns[0]"),
      bad_column("{}", "columns[0]: 'cost'"),
      bad_column(R"({"cost": -1})", "columns[0]: 'rows'"),
      bad_column(R"({"cost": "-1", "rows": [0]})", "columns[0]: 'cost'"),
      bad_column(R"({"cost": null, "rows": [0]})", "columns[0]: 'cost'"),
      bad_column(R"({"cost": NaN, "rows": [0]})", "line 1"),
      bad_column(R"({"cost": Infinity, "rows": [0]})", "line 1"),
      bad_column(R"({"cost": 1e999, "rows": [0]})", "1e999"),
      bad_column(R"({"cost": -1e999, "rows": [0]})", "1e999"),
      bad_column(R"({"cost": 1e13, "rows": [0]})", "column 0"),
      bad_column(R"({"cost": -1, "rows": 0})", "columns[0]: 'rows'"),
      bad_column(R"({"cost": -1, "rows": []})", "column 0"),
      bad_column(R"({"cost": -1, "rows": ["0"]})", "columns[0]: 'rows'"),
      bad_column(R"({"cost": -1, "rows": [0.5]})", "columns[0]: 'rows'"),
      bad_column(R"({"cost": -1, "rows": [3]})", "column 0: it uses row 3"),
      bad_column(R"({"cost": -1, "rows": [-1]})", "column 0: it uses row -1"),
      bad_column(R"({"cost": -1, "rows": [0, 0]})", "column 0"),
      bad_column(R"({"cost": -1, "rows": [0, 2]})", "column 0: it uses two rows of dimension 1"),
      bad_column(R"({"cost": -1, "rows": [9223372036854775807]})", "columns[0]: 'rows'"),
      bad_column(R"({"cost": -1, "rows": [18446744073709551615]})", "columns[0]: 'rows'"),
      bad_column(R"({"cost": -1, "rows": [1e3]})", "columns[0]: 'rows'"),
      bad_column(R"({"cost": -1, "rows": [1]}, {"cost": 1})", "columns[1]: 'rows'"),
  };
  list.push_back({std::string(100000, '['), "line 1"});
  list.push_back({std::string(100000, '[') + std::string(100000, ']'), "object"});
  list.push_back(bad_column(
      R"({"cost": -1, "rows": )" + std::string(100000, '[') + std::string(100000, ']') + "}",
      "columns[0]: 'rows'"));
  return list;
}

TEST(WindowFileTest, MalformedWindowsAreRefusedWithFileAndPlace) {
  for (const Malformed& malformed : malformed_windows()) {
    const std::string shown = malformed.text.substr(0, 200);
    try {
      static_cast<void>(parse_window(malformed.text, "folder/w.json"));
      ADD_FAILURE() << "taken: " << shown;
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with("folder/w.json: ")) << message << "\n for " << shown;
      EXPECT_NE(message.find(malformed.place), std::string::npos) << message << "\n for " << shown;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

/// Parsed, or refused with the file's name; anything else that is thrown fails the test.
void expect_parsed_or_refused(const std::string& text) {
  try {
    static_cast<void>(parse_window(text, "w.json"));
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("w.json: ")) << error.what();
  }
}

TEST(WindowFileTest, TruncatedWindowsAreRefused) {
  const std::string text = window_json(problem_of(7), {{"scenario", "A"}});
  const std::size_t end = text.rfind('}');
  for (std::size_t length = 0; length <= end; ++length) {
    EXPECT_THROW(static_cast<void>(parse_window(text.substr(0, length), "w.json")), InputError);
  }
}

TEST(WindowFileTest, RandomBytesAndRandomDamageAreSurvived) {
  Draw draw(1);
  const std::string text = window_json(problem_of(7), {});
  for (int trial = 0; trial < 3000; ++trial) {
    std::string bytes =
        trial % 2 == 0 ? text : std::string(static_cast<std::size_t>(draw.below(80)), ' ');
    const int changes = trial % 2 == 0 ? 1 + draw.below(4) : static_cast<int>(bytes.size());
    for (int i = 0; i < changes; ++i) {
      const int at = trial % 2 == 0 ? draw.below(static_cast<int>(bytes.size())) : i;
      bytes[static_cast<std::size_t>(at)] = static_cast<char>(draw.below(256));
    }
    expect_parsed_or_refused(bytes);
  }
}

TEST(WindowFileTest, MpsAndLpRefuseWindowsWithoutColumns) {
  for (const char* name : {"empty", "no columns"}) {
    EXPECT_THROW(static_cast<void>(window_mps(tiny_problem(name).problem)), InputError);
    EXPECT_THROW(static_cast<void>(window_lp(tiny_problem(name).problem)), InputError);
  }
}

}  // namespace
}  // namespace mda::testing
