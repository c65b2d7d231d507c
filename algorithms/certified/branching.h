// Where a fractional point of the LP is best divided.
#pragma once

#include <utility>
#include <vector>

#include "algorithms/certified/packing.h"

namespace mda {

using RowPair = std::pair<int, int>;

/// Either a pair of rows or a column, and the alive columns that die on its sides.
struct Division {
  RowPair rows = {-1, -1};
  int column = -1;
  /// When one column uses both rows or none either (when the column is chosen), and when no column
  /// uses both (when it is not).
  std::vector<int> with;
  std::vector<int> without;

  /// Whether either side is less than the whole.
  [[nodiscard]] bool divides() const noexcept { return !with.empty() && !without.empty(); }
};

/// At most `most` pairs of rows whose use by one column is nearest a half, a little above, the
/// nearest first. O(entries of the point).
[[nodiscard]] std::vector<RowPair> halved_pairs(const Packing& packing,
                                                const std::vector<std::pair<int, double>>& point,
                                                int most);

/// `alive`: column numbers. O(their nonzeros).
[[nodiscard]] Division division_by(const Packing& packing, const std::vector<int>& alive,
                                   RowPair rows);

/// By the column whose value is nearest a half of those that divide; empty if no alive column has
/// an alive rival. O(columns * nonzeros).
[[nodiscard]] Division division_by_column(const Packing& packing, const std::vector<int>& alive,
                                          const std::vector<std::pair<int, double>>& point);

/// The alive columns that share a row with `column`, without itself.
[[nodiscard]] std::vector<int> alive_rivals(const Packing& packing, const std::vector<int>& alive,
                                            int column);

}  // namespace mda
