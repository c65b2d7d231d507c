// Writes flat JSON objects, one per line, without building a document first: a sweep writes tens of
// thousands of them.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mda {

/// Appends to `text`. Numbers that are not finite become null; doubles are written with as few
/// digits as give them back unchanged.
class JsonLine {
 public:
  explicit JsonLine(std::string& text) : text_(text) { text_ += '{'; }

  template <typename T>
  void field(std::string_view name, const T& value) {
    write_name(name);
    write(value);
  }

  /// An object as a field: what is written until its end is in it.
  void begin_object(std::string_view name) {
    write_name(name);
    text_ += '{';
  }
  void end_object() { text_ += '}'; }

  void end() { text_ += "}\n"; }

 private:
  void write_name(std::string_view name) {
    if (text_.back() != '{') text_ += ',';
    fmt::format_to(std::back_inserter(text_), "\"{}\":", name);
  }
  void write(std::string_view value) {
    text_ += nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  void write(const std::string& value) { write(std::string_view(value)); }
  void write(bool value) { text_ += value ? "true" : "false"; }
  void write(double value) {
    if (std::isfinite(value)) {
      fmt::format_to(std::back_inserter(text_), "{}", value);
    } else {
      text_ += "null";
    }
  }
  template <std::integral T>
  void write(T value) {
    fmt::format_to(std::back_inserter(text_), "{}", value);
  }
  template <typename T>
  void write(const std::optional<T>& value) {
    if (value) {
      write(*value);
    } else {
      text_ += "null";
    }
  }
  template <typename T>
  void write(const std::vector<T>& values) {
    text_ += '[';
    for (const auto& value : values) {
      if (text_.back() != '[') text_ += ',';
      write(value);
    }
    text_ += ']';
  }

  std::string& text_;
};

}  // namespace mda
