#include "algorithms/api/solution.h"

#include <cmath>

namespace mda {

std::string_view word(Answer answer) noexcept {
  switch (answer) {
    case Answer::kSelection:
      return "selection";
    case Answer::kRelaxation:
      return "relaxation";
    case Answer::kMarginals:
      return "marginals";
  }
  return "";
}

std::string_view word(Status status) noexcept {
  switch (status) {
    case Status::kOptimal:
      return "optimal";
    case Status::kFeasible:
      return "feasible";
    case Status::kNoAnswer:
      return "no_answer";
    case Status::kFailed:
      return "failed";
  }
  return "";
}

std::string_view word(Stop stop) noexcept {
  switch (stop) {
    case Stop::kFinished:
      return "finished";
    case Stop::kDeadline:
      return "deadline";
    case Stop::kIterationLimit:
      return "iteration_limit";
    case Stop::kError:
      return "error";
  }
  return "";
}

double cost_tolerance(double cost) noexcept { return 1e-5 + 1e-9 * std::abs(cost); }

Solution selection_of(const std::vector<int>& columns, int column_count, Status status) {
  Solution s;
  s.status = status;
  s.x.assign(static_cast<std::size_t>(column_count), 0.0);
  for (const int j : columns) s.x[static_cast<std::size_t>(j)] = 1.0;
  return s;
}

}  // namespace mda
