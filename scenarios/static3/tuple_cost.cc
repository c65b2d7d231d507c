#include "scenarios/static3/tuple_cost.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mda {
namespace {

constexpr double kFloor = 1e-9;

double squared(double value) { return value * value; }

}  // namespace

SensorCosts::SensorCosts(const ScenarioSpec& spec)
    : detection_(spec.world.detection_probability),
      missed_(std::max(kFloor, 1.0 - detection_)),
      false_alarms_(spec.three_sensors.value().false_alarms_per_target),
      lonely_(std::max(kFloor, false_alarms_ + detection_ * squared(missed_))),
      variance_(squared(spec.three_sensors->sigma_per_spacing)) {}

double SensorCosts::constant(int reports) const {
  const double k = reports;
  return -k * std::log(detection_) - (kSensors - k) * std::log(missed_) +
         (k - 1.0) * std::log(2.0 * std::numbers::pi * variance_) + std::log(k) +
         k * std::log(lonely_);
}

double SensorCosts::column(std::span<const SensorReport* const> reports) const {
  if (reports.size() < 2) return 0.0;
  double sum_of_squares = 0.0;  // |S| times SS: over all pairs, squared distances
  for (std::size_t i = 0; i < reports.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      sum_of_squares +=
          squared(reports[i]->x - reports[j]->x) + squared(reports[i]->y - reports[j]->y);
    }
  }
  const auto k = static_cast<double>(reports.size());
  return constant(static_cast<int>(reports.size())) + sum_of_squares / (2.0 * k * variance_);
}

double SensorCosts::widest(int reports) const { return -2.0 * constant(reports); }

double SensorCosts::alone() const {
  return -std::log1p(detection_ * squared(missed_) / false_alarms_);
}

double SensorCosts::distance(const SensorReport& a, const SensorReport& b) const {
  return (squared(a.x - b.x) + squared(a.y - b.y)) / (2.0 * variance_);
}

}  // namespace mda
