// Named problems small enough to check by hand, with their optima. Every bug adds one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/api/problem.h"

namespace mda::testing {

struct TinyProblem {
  std::string name;
  AssociationProblem problem;
  std::optional<double> optimum;   ///< nats; nothing: no choice fills the exactly-once rows
  std::optional<double> lp_value;  ///< of the relaxation; nothing: it is infeasible too
};

/// All of them, drawn in tiny_problems.cc.
[[nodiscard]] const std::vector<TinyProblem>& tiny_problems();

/// The one of that name; std::out_of_range if there is none.
[[nodiscard]] const TinyProblem& tiny_problem(std::string_view name);

}  // namespace mda::testing
