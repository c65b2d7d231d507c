// Reports near a point, found without looking at all of them.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "scenarios/static3/sensor_scene.h"

namespace mda {

/// The reports of one sensor in square cells. Does not copy them: they must stay.
class ReportGrid {
 public:
  /// `radius` > 0: of the searches. O(reports).
  ReportGrid(std::span<const SensorReport> reports, double side, double radius);

  /// Calls visit(j) for every report j in the nine cells around the point: for all that are within
  /// the radius, and for some that are not.
  template <typename Visit>
  void visit_near(const SensorReport& point, Visit visit) const {
    const int column = cell_of(point.x);
    const int row = cell_of(point.y);
    for (int r = std::max(0, row - 1); r <= std::min(cells_ - 1, row + 1); ++r) {
      const auto first = static_cast<std::size_t>(r * cells_ + std::max(0, column - 1));
      const auto last = static_cast<std::size_t>(r * cells_ + std::min(cells_ - 1, column + 1));
      for (int i = begin_[first]; i < begin_[last + 1]; ++i) {
        visit(report_[static_cast<std::size_t>(i)]);
      }
    }
  }

 private:
  /// Points outside the square count to the cells at its edge.
  [[nodiscard]] int cell_of(double coordinate) const;
  [[nodiscard]] std::size_t cell_of(const SensorReport& report) const;

  double width_ = 0.0;
  int cells_;                ///< on a side
  std::vector<int> begin_;   ///< per cell: into report_
  std::vector<int> report_;  ///< by cell
};

}  // namespace mda
