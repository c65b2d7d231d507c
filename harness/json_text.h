// JSON that people and other programs write: read without guessing.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace mda {

/// Throws InputError, beginning with `file`, if it is no JSON, or if an object has a key twice, of
/// which readers take one or the other.
[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::string& file);

/// The first key of an object that is none of these, or an empty text.
[[nodiscard]] std::string unknown_key(const nlohmann::json& object,
                                      std::initializer_list<std::string_view> known);

}  // namespace mda
