// Text files of lines that are words between blanks.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mda {

struct WordLine {
  std::int64_t number = 0;                ///< from 1; 0 before the first line
  std::array<std::string_view, 6> words;  ///< the first ones, which point into the text
  std::size_t count = 0;                  ///< of words, also of those that there is no room for
};

/// Gives the lines of a text one by one. A line ends with \n or \r\n, or where the text ends.
class WordLines {
 public:
  explicit WordLines(std::string_view text) : rest_(text) {}

  /// False, and `line` stays as it is, when there are no more lines.
  [[nodiscard]] bool next(WordLine& line) {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(std::min(rest_.size(), text.size() + 1));
    if (text.ends_with('\r')) text.remove_suffix(1);
    ++line.number;
    line.count = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
      if (is_blank(text[at])) continue;
      const std::size_t start = at;
      while (at < text.size() && !is_blank(text[at])) ++at;
      if (line.count < line.words.size()) line.words[line.count] = text.substr(start, at - start);
      ++line.count;
    }
    return true;
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t'; }

  std::string_view rest_;
};

}  // namespace mda
