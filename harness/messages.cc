#include "harness/messages.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <new>

namespace mda {

void tell(std::string_view text) noexcept {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text;
}

std::string plain_words(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
  const std::string_view message = error.what();
  if (!message.starts_with("[json.exception.")) return std::string(message);
  const std::string_view end_of_code = "] ";
  const auto end = message.find(end_of_code);
  return std::string(message.substr(end == std::string_view::npos ? 0 : end + end_of_code.size()));
}

}  // namespace mda
