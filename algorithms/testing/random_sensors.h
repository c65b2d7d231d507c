// Windows of three sensors at one instant, the same ones on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "algorithms/api/problem.h"

namespace mda::testing {

/// Of report i of sensor s and report j of sensor t, s < t.
using ReportDistance = std::function<double(int s, int i, int t, int j)>;

/// Any pair costs A / 2 - 4 and any triple (A12 + A13 + A23) / 3 - 9 nats; those that cost less
/// than 0 are columns. Rows are the reports of sensor 0, 1 and 2, at most once.
[[nodiscard]] AssociationProblem sensor_problem(const std::array<int, 3>& reports,
                                                const ReportDistance& distance);

/// Up to four targets in a small square and a few false alarms; at most 18 rows. A sensor may be
/// empty. `order` numbers each sensor's reports in another way (0: in the plain one).
[[nodiscard]] AssociationProblem random_sensor_problem(std::uint64_t seed, std::uint64_t order = 0);

}  // namespace mda::testing
