#include "harness/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "harness/errors.h"
#include "harness/messages.h"

namespace mda {
namespace {

using Json = nlohmann::json;

/// Refuses an object that has a key twice, of which the parser would take the last one. On its own:
/// the parser looks through all that it has read of a list after each of its items when it is
/// asked.
class RepeatedKeys final : public nlohmann::json_sax<Json> {
 public:
  explicit RepeatedKeys(const std::string& file) : file_(file) {}

  bool start_object(std::size_t /*elements*/) override {
    if (keys_.size() == 1) ++item_;
    keys_.emplace_back();
    return true;
  }
  bool end_object() override {
    keys_.pop_back();
    return true;
  }
  bool key(std::string& name) override {
    note(name);
    return true;
  }
  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(std::int64_t /*value*/) override { return true; }
  bool number_unsigned(std::uint64_t /*value*/) override { return true; }
  bool number_float(double /*value*/, const std::string& /*text*/) override { return true; }
  bool string(std::string& /*value*/) override { return true; }
  bool binary(Json::binary_t& /*value*/) override { return true; }
  bool start_array(std::size_t /*elements*/) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t /*at*/, const std::string& /*last*/,
                   const nlohmann::detail::exception& /*error*/) override {
    return false;
  }

 private:
  void note(const std::string& key) {
    if (!keys_.back().insert(key).second) {
      const std::string place = keys_.size() > 1 ? fmt::format("{}[{}]: ", list_, item_) : "";
      throw InputError(fmt::format("{}: {}'{}' is there twice", file_, place, key));
    }
    if (keys_.size() > 1) return;
    list_ = key;
    item_ = -1;
  }

  const std::string& file_;
  std::vector<std::set<std::string>> keys_;  ///< of the objects around the place that is parsed
  std::string list_;                         ///< the last key of the outermost
  int item_ = -1;                            ///< of that list
};

}  // namespace

Json parse_json(std::string_view text, const std::string& file) {
  if (const auto zero = text.find('\0'); zero != std::string_view::npos) {  // to Json the end
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
    throw InputError(fmt::format("{}: not JSON: a zero byte in line {}", file, line));
  }
  Json document;
  try {
    document = Json::parse(text);
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: not JSON: {}", file, plain_words(error)));
  }
  RepeatedKeys repeated_keys(file);
  Json::sax_parse(text, &repeated_keys);
  return document;
}

std::string unknown_key(const Json& object, std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) return key;
  }
  return {};
}

}  // namespace mda
