#include "harness/certificate_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "harness/errors.h"
#include "harness/json_text.h"
#include "harness/messages.h"

namespace mda {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;
using Kind = ProofStep::Kind;

constexpr int kCertificateSchema = 1;
constexpr std::pair<Kind, const char*> kKinds[] = {
    {Kind::kPrices, "prices"},      {Kind::kOddRows, "odd_rows"}, {Kind::kClique, "clique"},
    {Kind::kRowPair, "row_pair"},   {Kind::kColumn, "column"},    {Kind::kParts, "parts"},
    {Kind::kEnumerate, "enumerate"}};

OrderedJson json_of(const ProofStep& step) {
  switch (step.kind) {
    case Kind::kPrices:
      return {{"rows", step.rows},
              {"values", step.prices},
              {"cuts", step.cuts},
              {"cut_values", step.cut_prices}};
    case Kind::kOddRows:
    case Kind::kRowPair:
      return step.rows;
    case Kind::kClique:
      return step.columns;
    case Kind::kColumn:
      return step.columns.front();
    case Kind::kParts: {
      OrderedJson parts = OrderedJson::array();
      for (std::size_t p = 0; p < step.part_rows.size(); ++p) {
        parts.push_back({{"rows", step.part_rows[p]}, {"floor", step.part_floors[p]}});
      }
      return parts;
    }
    case Kind::kEnumerate:
      return true;
  }
  return {};
}

/// A value of the file, and where it is, for messages.
class Place {
 public:
  Place(const Json& value, std::string where) : value_(value), where_(std::move(where)) {}

  [[noreturn]] void fail(std::string_view why) const {
    throw InputError(fmt::format("{}: {}", where_, why));
  }

  [[nodiscard]] Place member(const char* key) const {
    if (!value_.is_object() || !value_.contains(key)) fail(fmt::format("'{}' is missing", key));
    return {value_[key], fmt::format("{}: '{}'", where_, key)};
  }

  void refuse_keys_but(std::initializer_list<std::string_view> known) const {
    const std::string unknown = unknown_key(value_, known);
    if (!unknown.empty()) fail(fmt::format("unknown key '{}'", one_line(unknown)));
  }

  [[nodiscard]] std::vector<Place> items() const {
    if (!value_.is_array()) fail("it must be a list");
    std::vector<Place> items;
    for (std::size_t i = 0; i < value_.size(); ++i) {
      items.emplace_back(value_[i], fmt::format("{}[{}]", where_, i));
    }
    return items;
  }

  template <typename Number>
  [[nodiscard]] Number number() const {
    const bool is_signed = value_.is_number_integer() && !value_.is_number_unsigned();
    const bool fits = is_signed ? std::in_range<Number>(value_.get<std::int64_t>())
                                : value_.is_number_unsigned() &&
                                      std::in_range<Number>(value_.get<std::uint64_t>());
    if (!fits) fail("it must be a whole number of 32 bits, or of 64 where it is a price or cost");
    return value_.get<Number>();
  }

  template <typename Number>
  [[nodiscard]] std::vector<Number> numbers() const {
    std::vector<Number> numbers;
    for (const Place& item : items()) numbers.push_back(item.number<Number>());
    return numbers;
  }

  [[nodiscard]] std::string text() const {
    if (!value_.is_string()) fail("it must be a text");
    return value_.get<std::string>();
  }

  [[nodiscard]] const Json& json() const { return value_; }

 private:
  const Json& value_;
  std::string where_;
};

ProofStep step_of(const Place& place) {
  const Json& json = place.json();
  if (!json.is_object() || json.size() != 1) place.fail("a step is an object of one key");
  ProofStep step;
  const auto* const kind = std::ranges::find(
      kKinds, json.begin().key(), [](const auto& entry) { return std::string_view(entry.second); });
  if (kind == std::end(kKinds)) {
    place.fail(fmt::format("unknown step '{}'", one_line(json.begin().key())));
  }
  step.kind = kind->first;
  const Place value = place.member(kind->second);
  switch (step.kind) {
    case Kind::kPrices:
      value.refuse_keys_but({"rows", "values", "cuts", "cut_values"});
      step.rows = value.member("rows").numbers<int>();
      step.prices = value.member("values").numbers<std::int64_t>();
      step.cuts = value.member("cuts").numbers<int>();
      step.cut_prices = value.member("cut_values").numbers<std::int64_t>();
      break;
    case Kind::kOddRows:
    case Kind::kRowPair:
      step.rows = value.numbers<int>();
      break;
    case Kind::kClique:
      step.columns = value.numbers<int>();
      break;
    case Kind::kColumn:
      step.columns = {value.number<int>()};
      break;
    case Kind::kParts:
      for (const Place& part : value.items()) {
        part.refuse_keys_but({"rows", "floor"});
        step.part_rows.push_back(part.member("rows").numbers<int>());
        step.part_floors.push_back(part.member("floor").number<std::int64_t>());
      }
      break;
    case Kind::kEnumerate:
      if (value.json() != true) value.fail("it must be true");
      break;
  }
  return step;
}

}  // namespace

std::string certificate_json(const CertificateFile& file) {
  OrderedJson steps = OrderedJson::array();
  for (const ProofStep& step : file.certificate.steps) {
    const auto* const kind =
        std::ranges::find(kKinds, step.kind, &std::pair<Kind, const char*>::first);
    steps.push_back({{kind->second, json_of(step)}});
  }
  const OrderedJson json = {{"schema", kCertificateSchema},  {"fingerprint", file.fingerprint},
                            {"bits", file.certificate.bits}, {"cost", file.certificate.cost},
                            {"columns", file.columns},       {"steps", std::move(steps)}};
  return json.dump() + "\n";
}

CertificateFile parse_certificate(std::string_view text, const std::string& file) {
  const Json json = parse_json(text, file);
  const Place place(json, file);
  if (place.member("schema").number<int>() != kCertificateSchema) {
    place.fail(fmt::format("'schema' must be {}", kCertificateSchema));
  }
  place.refuse_keys_but({"schema", "fingerprint", "bits", "cost", "columns", "steps"});
  CertificateFile result;
  result.fingerprint = place.member("fingerprint").text();
  result.columns = place.member("columns").numbers<int>();
  result.certificate.bits = place.member("bits").number<int>();
  result.certificate.cost = place.member("cost").number<std::int64_t>();
  for (const Place& step : place.member("steps").items()) {
    result.certificate.steps.push_back(step_of(step));
  }
  return result;
}

}  // namespace mda
