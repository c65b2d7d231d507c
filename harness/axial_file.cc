#include "harness/axial_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <vector>

#include "harness/errors.h"

namespace mda {
namespace {

constexpr int kMostIndices = 150;
constexpr double kLargestCost = 1e12;
constexpr std::string_view kBlanks = " \t\r";

/// The numbers of a text, line by line.
class NumberLines {
 public:
  NumberLines(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  [[noreturn]] void fail(std::string_view why) const {
    throw InputError(fmt::format("{}:{}: {}", file_, line_, why));
  }

  /// The numbers of the next line. Refuses what is none, and a text that has ended.
  const std::vector<double>& next(std::string_view wanted) {
    ++line_;
    numbers_.clear();
    if (rest_.empty()) fail(fmt::format("the file ends where {} should be", wanted));
    std::string_view text = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(rest_.size(), text.size() + 1));
    while (!skip_blanks(text).empty()) numbers_.push_back(number(text));
    return numbers_;
  }

  void expect_end() {
    while (!rest_.empty()) {
      if (!next("nothing").empty()) fail("there is more than n * n lines of costs");
    }
  }

 private:
  static std::string_view skip_blanks(std::string_view& text) {
    text.remove_prefix(std::min(text.size(), text.find_first_not_of(kBlanks)));
    return text;
  }

  /// Takes the first word off.
  double number(std::string_view& text) const {
    const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = error == std::errc{} && end == word.data() + word.size();
    if (!whole || !(std::abs(value) <= kLargestCost)) {
      fail(fmt::format("'{}' is not a number within 1e12", word));
    }
    text.remove_prefix(word.size());
    return value;
  }

  std::string_view rest_;
  const std::string& file_;
  int line_ = 0;
  std::vector<double> numbers_;
};

int size_of(NumberLines& lines) {
  const std::vector<double>& first = lines.next("n");
  if (first.size() != 1)
    lines.fail(fmt::format("{} numbers where n alone should be", first.size()));
  const double n = first[0];
  if (n != std::floor(n) || n < 1.0 || n > kMostIndices) {
    lines.fail(fmt::format("n is {}: it must be a whole number from 1 to {}", n, kMostIndices));
  }
  return static_cast<int>(n);
}

}  // namespace

AssociationProblem parse_axial3(std::string_view text, const std::string& file) {
  NumberLines lines(text, file);
  const int n = size_of(lines);
  ProblemBuilder builder;
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (int i = 0; i < n; ++i) builder.add_row(dimension, RowUse::kExactlyOnce);
  }
  for (int pair = 0; pair < n * n; ++pair) {
    const std::vector<double>& costs = lines.next(fmt::format("line {} of {}", pair + 1, n * n));
    if (costs.size() != static_cast<std::size_t>(n)) {
      lines.fail(fmt::format("{} costs where {} should be", costs.size(), n));
    }
    for (int k = 0; k < n; ++k) {
      const std::array<int, 3> rows = {pair / n, n + pair % n, 2 * n + k};
      builder.add_column(costs[static_cast<std::size_t>(k)], rows);
    }
  }
  lines.expect_end();
  return builder.build();
}

}  // namespace mda
