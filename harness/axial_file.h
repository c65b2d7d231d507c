// Dense axial three-dimensional assignment problems as text files.
#pragma once

#include <string>
#include <string_view>

#include "algorithms/api/problem.h"

namespace mda {

/// The problem in `text`: n, then n * n lines of n costs c[i][j][k], i slowest, k fastest; blank
/// lines at the end are allowed. Every index is used exactly once: rows are the i (dimension 1),
/// then the j, then the k; column (i * n + j) * n + k uses those three. n is 1 to 150. Throws
/// InputError that begins with `file` and names the line.
[[nodiscard]] AssociationProblem parse_axial3(std::string_view text, const std::string& file);

}  // namespace mda
