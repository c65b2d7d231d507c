#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "algorithms/catalog.h"
#include "harness/axial_file.h"
#include "harness/certificate_check.h"
#include "harness/certificate_file.h"
#include "harness/commands.h"
#include "harness/errors.h"
#include "harness/files.h"
#include "harness/judge.h"
#include "harness/window_file.h"
#include "harness/window_rows.h"

namespace mda {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number_or_null(const std::optional<double>& value) {
  return value ? number_or_null(*value) : Json(nullptr);
}

/// The ranked choices with the costs that the referee finds.
Json ranked_of(const AssociationProblem& problem, const Solution& solution) {
  const std::vector<double> costs = ranked_costs(problem, solution.ranked);
  Json ranked = Json::array();
  for (std::size_t i = 0; i < costs.size(); ++i) {
    ranked.push_back({{"cost_nats", number_or_null(costs[i])}, {"columns", solution.ranked[i]}});
  }
  return ranked;
}

Json result_of(const AssociationProblem& problem, const Attempt& attempt,
               const Verdicts& verdicts) {
  const Row row = attempt_row({}, problem, attempt, verdicts);
  const Solution& solution = attempt.solution;
  const bool has_cost = attempt.examined.well_formed;
  Json columns = Json::array();
  Json values = Json::array();  // of relaxations and marginals, one per listed column
  for (std::size_t j = 0; j < solution.x.size(); ++j) {
    if (!(solution.x[j] > kIntegralTolerance)) continue;
    columns.push_back(j);
    if (solution.answer != Answer::kSelection) values.push_back(solution.x[j]);
  }
  return {{"algorithm", attempt.player->entry->name},
          {"fingerprint", problem.fingerprint()},
          {"answer", word(solution.answer)},
          {"status", word(solution.status)},
          {"stop", word(solution.stop)},
          {"cost_nats", has_cost ? number_or_null(attempt.examined.cost) : Json(nullptr)},
          {"bound_nats", number_or_null(solution.lower_bound)},
          {"certified_bound_nats", number_or_null(attempt.certified_bound)},
          {"row_violation", has_cost ? Json(attempt.examined.row_violation) : Json(nullptr)},
          {"fractional", row.fractional ? Json(*row.fractional) : Json(nullptr)},
          {"seconds", attempt.wall_ms / 1e3},
          {"cpu_seconds", attempt.cpu_ms / 1e3},
          {"columns", columns},
          {"values", values},
          {"ranked", ranked_of(problem, solution)},
          {"note", attempt.note}};
}

void print_for_people(const AssociationProblem& problem, const Json& result) {
  fmt::print("{} rows, {} columns, {} components\n", problem.rows(), problem.columns(),
             problem.shape().components);
  for (const auto& [key, value] : result.items()) {
    const bool is_blank = value.is_string() && value.get_ref<const std::string&>().empty();
    if (value.is_null() || is_blank || value.is_array()) continue;
    fmt::print("{:<21} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  const Json& values = result["values"];
  for (std::size_t i = 0; i < result["columns"].size(); ++i) {
    const int j = result["columns"][i].get<int>();
    const auto rows = problem.rows_of(j);
    const std::string value =
        values.empty() ? "" : fmt::format("  value {:.6f}", values[i].get<double>());
    fmt::print("  column {:<6} cost {:>12.6f}{}  rows {}\n", j, problem.cost(j), value,
               fmt::join(rows.begin(), rows.end(), " "));
  }
  int rank = 0;
  for (const Json& choice : result["ranked"]) {
    const Json& cost = choice["cost_nats"];
    fmt::print("  choice {:<6} cost {:>12.6f}  columns {}\n", ++rank,
               cost.is_null() ? NAN : cost.get<double>(),
               fmt::join(choice["columns"].get<Choice>(), " "));
  }
}

/// Writes the proof after checking it; false if there is none.
bool write_certificate(const AssociationProblem& problem, const Solution& solution,
                       const std::string& path) {
  if (solution.certificate == nullptr) return false;
  CertificateFile file{problem.fingerprint(), {}, *solution.certificate};
  for (int j = 0; j < problem.columns(); ++j) {
    if (solution.x[static_cast<std::size_t>(j)] > 0.5) file.columns.push_back(j);
  }
  const std::string fault = certificate_fault(problem, file.columns, file.certificate);
  if (!fault.empty()) throw std::logic_error("the certificate is refused: " + fault);
  write_file(path, certificate_json(file));
  return true;
}

int exit_code(const Attempt& attempt) {
  if (attempt.refuted) return kWrongAnswer;
  return attempt.solution.status == Status::kFailed ? kCellsFailed : kWell;
}

}  // namespace

int solve(const SolveCommand& command) {
  std::error_code none;
  if (std::filesystem::equivalent(command.file, command.certificate, none)) {
    throw InputError(
        fmt::format("{}: the proof would replace the problem that it is about", command.file));
  }
  const CatalogEntry* entry = find_algorithm(command.algorithm);
  if (entry == nullptr) {
    throw InputError(fmt::format("unknown algorithm '{}': 'mda-bench list algorithms' names them",
                                 command.algorithm));
  }
  const auto parse = command.format == ProblemFormat::kAxial3 ? parse_axial3 : parse_window;
  const AssociationProblem problem = parse(read_file(command.file), command.file);
  std::vector<Player> players;
  players.push_back({entry, true, entry->make()});
  const Verdicts verdicts =
      judge(problem, solve_all(problem, players, {.time_limit_s = command.time_limit_s}));
  const Attempt& attempt = verdicts.attempts.front();
  if (attempt.skipped) {
    throw InputError(
        fmt::format("{}: '{}' declines: {}", command.file, command.algorithm, attempt.note));
  }
  const Solution& solution = attempt.solution;
  if (!command.certificate.empty() && solution.status == Status::kOptimal &&
      solution.certificate == nullptr) {
    throw InputError(fmt::format("{}: '{}' writes no certificate; tree-exact does",
                                 command.certificate, command.algorithm));
  }
  const Json result = result_of(problem, attempt, verdicts);
  if (command.json) {
    fmt::print("{}\n", result.dump(2));
  } else {
    print_for_people(problem, result);
  }
  if (!command.certificate.empty() && !write_certificate(problem, solution, command.certificate)) {
    fmt::print(stderr, "mda-bench: {}: not written, nothing is proven yet\n", command.certificate);
    return kCellsFailed;
  }
  return exit_code(attempt);
}

}  // namespace mda
