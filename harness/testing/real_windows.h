// Windows as the harness meets them.
#pragma once

#include <string_view>
#include <vector>

#include "algorithms/api/problem.h"

namespace mda::testing {

struct WindowSource {
  std::string_view scenario;
  int window_k = 3;
  double scan_period_s = 8.0;
  int replicate = 1;
  bool views = false;
};

/// The windows of every `step`-th scan, advanced by the reference, that have columns.
[[nodiscard]] std::vector<AssociationProblem> real_windows(const WindowSource& source, int step);

}  // namespace mda::testing
