#include "scenarios/static3/report_grid.h"

#include <algorithm>
#include <cmath>

namespace mda {
namespace {

/// Cells that are wider than the radius where it is so small that most would be empty.
int cells_on_a_side(std::size_t reports, double side, double radius) {
  const double enough = std::sqrt(static_cast<double>(reports)) + 1.0;
  return static_cast<int>(std::clamp(std::floor(side / radius), 1.0, enough));
}

}  // namespace

ReportGrid::ReportGrid(std::span<const SensorReport> reports, double side, double radius)
    : cells_(cells_on_a_side(reports.size(), side, radius)) {
  width_ = side / cells_;
  begin_.assign(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_) + 1, 0);
  for (const SensorReport& report : reports) ++begin_[cell_of(report) + 1];
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  std::vector<int> next = begin_;
  report_.resize(reports.size());
  for (std::size_t j = 0; j < reports.size(); ++j) {
    const auto place = static_cast<std::size_t>(next[cell_of(reports[j])]++);
    report_[place] = static_cast<int>(j);
  }
}

int ReportGrid::cell_of(double coordinate) const {
  return static_cast<int>(std::clamp(std::floor(coordinate / width_), 0.0, cells_ - 1.0));
}

std::size_t ReportGrid::cell_of(const SensorReport& report) const {
  return static_cast<std::size_t>(cell_of(report.y) * cells_ + cell_of(report.x));
}

}  // namespace mda
