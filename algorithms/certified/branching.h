// Where a fractional point of the LP is best divided.
#pragma once

#include <utility>
#include <vector>

#include "algorithms/certified/packing.h"

namespace mda {

/// Either a pair of rows or, if there is no pair worth it, a column.
struct Division {
  std::pair<int, int> rows = {-1, -1};
  int column = -1;
  /// Alive columns that die when one column uses both rows or none either (when the column is
  /// chosen), and when no column uses both (when it is not). Neither is empty.
  std::vector<int> with;
  std::vector<int> without;
};

/// At most `most` pairs whose use by one column is nearest a half, a little above, the nearest
/// first; or where no pair divides, the column that is. Empty: no alive column has an alive rival.
/// `alive`: column numbers. O(most * nonzeros).
[[nodiscard]] std::vector<Division> divisions(const Packing& packing, const std::vector<int>& alive,
                                              const std::vector<std::pair<int, double>>& point,
                                              int most);

/// The alive columns that share a row with `column`, without itself.
[[nodiscard]] std::vector<int> alive_rivals(const Packing& packing, const std::vector<int>& alive,
                                            int column);

}  // namespace mda
