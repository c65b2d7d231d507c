#include "harness/window_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "harness/errors.h"
#include "harness/json_text.h"

namespace mda {
namespace {

using Json = nlohmann::json;

constexpr int kWindowSchema = 1;
constexpr std::string_view kAtMostOnceWord = "at-most-once";
constexpr std::string_view kExactlyOnceWord = "exactly-once";

/// A place in a window file, for messages.
class Place {
 public:
  Place(const std::string& file, std::string_view what, std::size_t number)
      : file_(file), what_(what), number_(number) {}

  [[noreturn]] void fail(std::string_view why) const {
    throw InputError(fmt::format("{}: {}[{}]: {}", file_, what_, number_, why));
  }

  [[nodiscard]] const Json& member(const Json& object, const char* key) const {
    if (!object.is_object()) fail("it must be an object");
    const auto found = object.find(key);
    if (found == object.end()) fail(fmt::format("'{}' is missing", key));
    return *found;
  }

  void refuse_keys_but(const Json& object, std::initializer_list<std::string_view> known) const {
    const std::string unknown = unknown_key(object, known);
    if (!unknown.empty()) fail(fmt::format("unknown key '{}'", unknown));
  }

  [[nodiscard]] int integer(const Json& value, std::string_view key) const {
    if (!value.is_number_integer()) fail(fmt::format("'{}' must be an integer", key));
    const bool fits = value.is_number_unsigned() ? std::in_range<int>(value.get<std::uint64_t>())
                                                 : std::in_range<int>(value.get<std::int64_t>());
    if (!fits) fail(fmt::format("'{}' is out of range", key));
    return value.get<int>();
  }

 private:
  const std::string& file_;
  std::string_view what_;
  std::size_t number_;
};

const Json& list(const Json& document, const char* key, const std::string& file) {
  const auto found = document.find(key);
  if (found == document.end() || !found->is_array()) {
    throw InputError(fmt::format("{}: '{}' must be a list", file, key));
  }
  return *found;
}

Json parse_document(std::string_view text, const std::string& file) {
  Json document = parse_json(text, file);
  if (!document.is_object()) throw InputError(file + ": it must be a JSON object");
  const auto schema = document.find("schema");
  if (schema == document.end() || !schema->is_number_integer() || *schema != kWindowSchema) {
    throw InputError(fmt::format("{}: 'schema' must be {}", file, kWindowSchema));
  }
  const std::string unknown =
      unknown_key(document, {"schema", "dimensions", "rows", "columns", "provenance"});
  if (!unknown.empty()) throw InputError(fmt::format("{}: unknown key '{}'", file, unknown));
  return document;
}

void add_row(const Json& item, const Place& place, ProblemBuilder& builder) {
  const int dimension = place.integer(place.member(item, "dimension"), "dimension");
  const Json& use = place.member(item, "use");
  place.refuse_keys_but(item, {"dimension", "use"});
  if (use == kAtMostOnceWord) {
    builder.add_row(dimension, RowUse::kAtMostOnce);
  } else if (use == kExactlyOnceWord) {
    builder.add_row(dimension, RowUse::kExactlyOnce);
  } else {
    place.fail(fmt::format("'use' must be \"{}\" or \"{}\"", kAtMostOnceWord, kExactlyOnceWord));
  }
}

/// Without fixed tracks the scans' dimensions are 1 to `dimensions`, with them 0 to one less.
void check_dimensions(const Json& rows, int dimensions, const std::string& file) {
  std::set<int> named;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int dimension = rows[i]["dimension"].get<int>();
    named.insert(dimension);
    if (dimension > dimensions || std::ssize(named) > dimensions) {
      const Place place(file, "rows", i);
      place.fail(fmt::format("its dimension {} is one too many: 'dimensions' is {}", dimension,
                             dimensions));
    }
  }
}

void add_column(const Json& item, const Place& place, ProblemBuilder& builder) {
  const Json& cost = place.member(item, "cost");
  if (!cost.is_number()) place.fail("'cost' must be a number");
  const Json& rows = place.member(item, "rows");
  place.refuse_keys_but(item, {"cost", "rows"});
  if (!rows.is_array()) place.fail("'rows' must be a list");
  std::vector<int> numbers;
  for (const Json& row : rows) numbers.push_back(place.integer(row, "rows"));
  builder.add_column(cost.get<double>(), numbers);
}

/// "x0 + x5 + x7", broken into lines that every reader takes.
void append_sum(const std::vector<int>& columns, std::string& text) {
  constexpr int kPerLine = 12;
  int on_line = 0;
  for (const int j : columns) {
    if (on_line == kPerLine) text += "\n  ";
    on_line = on_line == kPerLine ? 1 : on_line + 1;
    fmt::format_to(std::back_inserter(text), " + x{}", j);
  }
}

}  // namespace

AssociationProblem parse_window(std::string_view text, const std::string& file) {
  const Json document = parse_document(text, file);
  const Json& rows = list(document, "rows", file);
  const Json& columns = list(document, "columns", file);
  ProblemBuilder builder;
  for (std::size_t i = 0; i < rows.size(); ++i) add_row(rows[i], {file, "rows", i}, builder);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    add_column(columns[j], {file, "columns", j}, builder);
  }
  if (const auto found = document.find("dimensions"); found != document.end()) {
    if (!found->is_number_unsigned() || *found > 1000000) {
      throw InputError(file + ": 'dimensions' must be an integer from 0 to 1000000");
    }
    builder.set_dimensions(found->get<int>());
    check_dimensions(rows, found->get<int>(), file);
  }
  try {
    return builder.build();
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
}

std::string window_json(const AssociationProblem& problem,
                        const nlohmann::ordered_json& provenance) {
  std::string text = fmt::format("{{\"schema\": {}, \"dimensions\": {},\n\"rows\": [",
                                 kWindowSchema, problem.shape().dimensions);
  auto out = std::back_inserter(text);
  for (int r = 0; r < problem.rows(); ++r) {
    fmt::format_to(out, "{}{{\"dimension\": {}, \"use\": \"{}\"}}", r == 0 ? "\n" : ",\n",
                   problem.dimension(r),
                   problem.use(r) == RowUse::kAtMostOnce ? kAtMostOnceWord : kExactlyOnceWord);
  }
  text += "],\n\"columns\": [";
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    fmt::format_to(out, "{}{{\"cost\": {:.17g}, \"rows\": [{}]}}", j == 0 ? "\n" : ",\n",
                   problem.cost(j), fmt::join(rows.begin(), rows.end(), ", "));
  }
  text += "],\n\"provenance\": " + provenance.dump() + "}\n";
  return text;
}

std::string window_mps(const AssociationProblem& problem) {
  if (problem.columns() == 0) throw InputError("this window has no columns, which MPS cannot say");
  std::string text = "NAME window\nROWS\n N cost\n";
  auto out = std::back_inserter(text);
  for (int r = 0; r < problem.rows(); ++r) {
    fmt::format_to(out, " {} r{}\n", problem.use(r) == RowUse::kAtMostOnce ? 'L' : 'E', r);
  }
  text += "COLUMNS\n MARKER 'MARKER' 'INTORG'\n";
  for (int j = 0; j < problem.columns(); ++j) {
    fmt::format_to(out, " x{} cost {:.17g}\n", j, problem.cost(j));
    for (const int r : problem.rows_of(j)) fmt::format_to(out, " x{} r{} 1\n", j, r);
  }
  text += " MARKER 'MARKER' 'INTEND'\nRHS\n";
  for (int r = 0; r < problem.rows(); ++r) fmt::format_to(out, " RHS r{} 1\n", r);
  text += "BOUNDS\n";
  for (int j = 0; j < problem.columns(); ++j) fmt::format_to(out, " UP BND x{} 1\n", j);
  text += "ENDATA\n";
  return text;
}

std::string window_lp(const AssociationProblem& problem) {
  if (problem.columns() == 0) {
    throw InputError("this window has no columns, which the LP format cannot say");
  }
  std::vector<std::vector<int>> columns_of_row(static_cast<std::size_t>(problem.rows()));
  std::string text = "Minimize\n cost:";
  auto out = std::back_inserter(text);
  for (int j = 0; j < problem.columns(); ++j) {
    fmt::format_to(out, "{} {:+.17g} x{}", j % 4 == 0 && j > 0 ? "\n  " : "", problem.cost(j), j);
    for (const int r : problem.rows_of(j)) {
      columns_of_row[static_cast<std::size_t>(r)].push_back(j);
    }
  }
  text += "\nSubject To\n";
  for (int r = 0; r < problem.rows(); ++r) {
    const auto& columns = columns_of_row[static_cast<std::size_t>(r)];
    if (columns.empty()) continue;
    fmt::format_to(out, " r{}:", r);
    append_sum(columns, text);
    text += problem.use(r) == RowUse::kAtMostOnce ? " <= 1\n" : " = 1\n";
  }
  text += "Binary\n";
  for (int j = 0; j < problem.columns(); ++j) fmt::format_to(out, " x{}\n", j);
  text += "End\n";
  return text;
}

}  // namespace mda
