#include "harness/answer.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "harness/json_line.h"

namespace mda {
namespace {

using Json = nlohmann::json;

/// The entries of x that are not 0; their values only if one of them is not 1.
void write_sparse(JsonLine& line, const char* columns_field, const char* values_field,
                  const std::vector<double>& x) {
  std::vector<int> columns;
  std::vector<double> values;
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (x[j] == 0.0) continue;
    columns.push_back(static_cast<int>(j));
    values.push_back(x[j]);
  }
  line.field(columns_field, columns);
  if (std::any_of(values.begin(), values.end(), [](double v) { return v != 1.0; })) {
    line.field(values_field, values);
  }
}

[[noreturn]] void refuse(const std::string& field, const std::string& why) {
  throw std::invalid_argument("'" + field + "' " + why);
}

const Json& member(const Json& answer, const char* field) {
  const auto found = answer.find(field);
  if (found == answer.end()) refuse(field, "is missing");
  return *found;
}

std::vector<double> numbers(const Json& answer, const char* field) {
  const Json& list = member(answer, field);
  if (!list.is_array()) refuse(field, "must be a list");
  std::vector<double> values;
  for (const Json& item : list) {
    if (!item.is_number()) refuse(field, "must hold numbers only");
    values.push_back(item.get<double>());
  }
  return values;
}

/// The vector of which `columns_field` and `values_field` (all 1 if absent) tell the entries.
std::vector<double> dense(const Json& answer, const char* columns_field, const char* values_field,
                          int size) {
  const std::vector<double> columns = numbers(answer, columns_field);
  const std::vector<double> values = answer.contains(values_field)
                                         ? numbers(answer, values_field)
                                         : std::vector<double>(columns.size(), 1.0);
  if (values.size() != columns.size()) refuse(values_field, "has another length than its columns");
  std::vector<double> x(static_cast<std::size_t>(size), 0.0);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!(columns[i] >= 0.0 && columns[i] < size)) refuse(columns_field, "names no column");
    double& value = x[static_cast<std::size_t>(columns[i])];
    if (value != 0.0) refuse(columns_field, "names a column twice");
    value = values[i];
  }
  return x;
}

/// A tuple as a list: its track's row, then the row of every scan, -1 for none.
std::vector<std::vector<int>> rows_of(const std::vector<Tuple>& tuples) {
  std::vector<std::vector<int>> lists;
  for (const Tuple& tuple : tuples) {
    lists.push_back({tuple.track});
    lists.back().insert(lists.back().end(), tuple.rows.begin(), tuple.rows.end());
  }
  return lists;
}

/// Lists of lists of whole numbers; none if the field is absent.
std::vector<std::vector<int>> whole_lists(const Json& answer, const char* field) {
  if (!answer.contains(field)) return {};
  try {
    return answer.at(field).get<std::vector<std::vector<int>>>();
  } catch (const Json::exception&) {
    refuse(field, "must hold lists of whole numbers");
  }
}

std::vector<Tuple> tuples_of(const Json& answer) {
  std::vector<Tuple> tuples;
  for (const std::vector<int>& list : whole_lists(answer, "tuples")) {
    if (list.empty()) refuse("tuples", "names no track");
    tuples.push_back({list.front(), {list.begin() + 1, list.end()}});
  }
  return tuples;
}

std::optional<int> count(const Json& answer, const char* field) {
  const auto found = answer.find(field);
  if (found == answer.end()) return std::nullopt;
  if (!found->is_number_integer()) refuse(field, "must be a whole number");
  return found->get<int>();
}

/// The choice whose word stands in a field.
template <typename Choice>
Choice choice_of(const Json& answer, const char* field, std::initializer_list<Choice> choices) {
  const Json& text = member(answer, field);
  for (const Choice choice : choices) {
    if (text == word(choice)) return choice;
  }
  refuse(field, "is " + text.dump());
}

}  // namespace

void append_answer_line(const Row& row, const Attempt& attempt, std::string& text) {
  const Solution& solution = attempt.solution;
  JsonLine line(text);
  write_key(row, line);
  line.field("asked", attempt.player->asked);
  line.field("answer", row.answer);
  line.field("claimed", word(attempt.claimed));
  line.field("stop", row.stop);
  write_sparse(line, "columns", "values", solution.x);
  if (!solution.relaxation.empty()) {
    write_sparse(line, "relaxation_columns", "relaxation_values", solution.relaxation);
  }
  if (!solution.tuples.empty()) line.field("tuples", rows_of(solution.tuples));
  if (!solution.ranked.empty()) line.field("ranked", solution.ranked);
  if (solution.stats.lp_fractional) line.field("lp_fractional", solution.stats.lp_fractional);
  if (solution.stats.off_column_paths) {
    line.field("off_column_paths", solution.stats.off_column_paths);
  }
  if (solution.stats.graph_nodes) line.field("graph_nodes", solution.stats.graph_nodes);
  if (solution.stats.graph_arcs) line.field("graph_arcs", solution.stats.graph_arcs);
  line.field("bound_nats", solution.lower_bound);
  line.field("row_dual", solution.row_dual);
  if (!attempt.player->asked) {
    line.begin_object("row");
    write_row(row, line);
    line.end_object();
  }
  line.end();
}

Solution solution_of(const Json& answer, int columns) {
  Solution solution;
  solution.status = choice_of(
      answer, "claimed", {Status::kOptimal, Status::kFeasible, Status::kNoAnswer, Status::kFailed});
  solution.answer =
      choice_of(answer, "answer", {Answer::kSelection, Answer::kRelaxation, Answer::kMarginals});
  solution.stop = choice_of(
      answer, "stop", {Stop::kFinished, Stop::kDeadline, Stop::kIterationLimit, Stop::kError});
  const bool has_x = solution.status == Status::kOptimal || solution.status == Status::kFeasible;
  if (has_x) solution.x = dense(answer, "columns", "values", columns);
  if (answer.contains("relaxation_columns")) {
    solution.relaxation = dense(answer, "relaxation_columns", "relaxation_values", columns);
  }
  solution.tuples = tuples_of(answer);
  solution.ranked = whole_lists(answer, "ranked");
  solution.stats.lp_fractional = count(answer, "lp_fractional");
  solution.stats.off_column_paths = count(answer, "off_column_paths");
  solution.stats.graph_nodes = count(answer, "graph_nodes");
  solution.stats.graph_arcs = count(answer, "graph_arcs");
  const Json& bound = member(answer, "bound_nats");
  if (bound.is_number()) solution.lower_bound = bound.get<double>();
  solution.row_dual = numbers(answer, "row_dual");
  return solution;
}

}  // namespace mda
