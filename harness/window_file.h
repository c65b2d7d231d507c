// Windows as files: JSON (read and written), MPS and LP (written, for other solvers).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "algorithms/api/problem.h"

namespace mda {

/// The problem in `text`: {"schema": 1, "rows": [{"dimension": 0, "use": "at-most-once"}, ...],
/// "columns": [{"cost": -3.2, "rows": [0, 4]}, ...]}; "dimensions" may say how many there are, and
/// what else there is ("provenance") is not looked at. Throws InputError that begins with `file`
/// and names the place.
[[nodiscard]] AssociationProblem parse_window(std::string_view text, const std::string& file);

/// parse_window reads it back: same fingerprint. `provenance` says where it comes from.
[[nodiscard]] std::string window_json(const AssociationProblem& problem,
                                      const nlohmann::ordered_json& provenance);

/// Free MPS, minimisation: rows r0, r1, ... (L or E, right-hand side 1), integer columns x0, x1,
/// ... with upper bound 1. Throws InputError if there are no columns: MPS readers refuse that.
[[nodiscard]] std::string window_mps(const AssociationProblem& problem);

/// The same in the LP format that CPLEX introduced; rows without columns are left out.
[[nodiscard]] std::string window_lp(const AssociationProblem& problem);

}  // namespace mda
