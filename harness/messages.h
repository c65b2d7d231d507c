// What is said to people on stderr.
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace mda {

/// Writes to stderr. If that fails there is nobody left to tell, so it never throws.
void tell(std::string_view text) noexcept;

/// `text` with a blank for every control character: names of files may hold line ends, and a
/// message is one line.
[[nodiscard]] std::string one_line(std::string text);

/// What an exception says, without the names and codes of the library that threw it.
[[nodiscard]] std::string plain_words(const std::exception& error);

}  // namespace mda
