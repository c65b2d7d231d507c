#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/certificate_check.h"
#include "harness/certificate_file.h"
#include "harness/clocks.h"
#include "harness/commands.h"
#include "harness/errors.h"
#include "harness/files.h"
#include "harness/window_file.h"

namespace mda {
namespace {

/// How much cheaper another choice may be because costs were rounded, nats: two choices of at most
/// as many columns as there are rows, each rounded by half a unit.
double rounding_margin(const AssociationProblem& problem, int bits) {
  return std::ldexp(static_cast<double>(problem.rows()), -bits);
}

/// In two digits, not less than it is.
std::string in_two_digits(double margin) {
  if (margin == 0.0) return "0";
  const double digit = std::pow(10.0, std::floor(std::log10(margin)) - 1.0);
  return fmt::format("{:.1e}", std::ceil(margin / digit) * digit);
}

double cost_of(const AssociationProblem& problem, const std::vector<int>& columns) {
  double cost = 0.0;
  for (const int j : columns) cost += problem.cost(j);
  return cost;
}

}  // namespace

int certify(const CertifyCommand& command) {
  const AssociationProblem problem = parse_window(read_file(command.window), command.window);
  const CertificateFile file =
      parse_certificate(read_file(command.certificate), command.certificate);
  const Stopwatch watch;
  std::string fault = certificate_fault(problem, file.columns, file.certificate);
  const double cpu_ms = watch.cpu_ms();
  if (file.fingerprint != problem.fingerprint()) fault = "it is about another window";
  const bool proven = fault.empty();
  nlohmann::ordered_json json = {{"proven", proven},
                                 {"fingerprint", problem.fingerprint()},
                                 {"reason", fault},
                                 {"cost_nats", nullptr},
                                 {"rounding_margin_nats", nullptr},
                                 {"steps", file.certificate.steps.size()},
                                 {"cpu_seconds", cpu_ms / 1e3}};
  const double margin = proven ? rounding_margin(problem, file.certificate.bits) : 0.0;
  if (proven) {
    json["cost_nats"] = cost_of(problem, file.columns);
    json["rounding_margin_nats"] = margin;
  }
  if (command.json) {
    fmt::print("{}\n", json.dump(2));
  } else if (proven) {
    fmt::print("proven: no choice costs less than {} nats, up to {} for rounded costs\n",
               cost_of(problem, file.columns), in_two_digits(margin));
    fmt::print("{} steps checked in {:.3f} ms of CPU time\n", file.certificate.steps.size(),
               cpu_ms);
  } else {
    fmt::print("refused: {}\n", fault);
  }
  return proven ? kWell : kWrongAnswer;
}

}  // namespace mda
