// What it costs to say that reports of different sensors are one target.
#pragma once

#include <span>

#include "scenarios/spec.h"
#include "scenarios/static3/sensor_scene.h"

namespace mda {

/// Likelihood ratio against "all of it is false alarms", the position of the target integrated out
/// under a flat density of targets rho (Deb, Yeddanapudi, Pattipati and Bar-Shalom 1997; Poore
/// 1994). With lambda the density of a sensor's false alarms and D = 1 - P_D, a tuple S costs
///
///     c(S) = -ln[ rho P_D^|S| D^(3-|S|) lambda^-|S| (2 pi s^2)^-(|S|-1) / |S| ] + SS / (2 s^2),
///
/// SS being the sum of squared distances from the tuple's mean. A report alone is a false alarm, or
/// a target that nobody else has seen: c({z}) = -ln(1 + q / lambda), q = rho P_D D^2. A column is
/// to cost c(S) - sum_{z in S} c({z}), so that a report alone costs nothing; the sum of c({z}) over
/// all reports is the constant left out. lambda cancels out of the difference:
///
///     column(S) = -ln[ rho P_D^|S| D^(3-|S|) (2 pi s^2)^-(|S|-1) / |S| ] + |S| ln(lambda + q)
///                 + SS / (2 s^2),
///
/// which is finite without false alarms, too. Where every target is always seen, D and lambda + q
/// count as 1e-9 (of rho) at least: then nothing is left alone that could be in a triple.
/// Lengths in mean target distances, areas accordingly: rho is 1.
class SensorCosts {
 public:
  /// `spec` has sensors and no sensor_fault().
  explicit SensorCosts(const ScenarioSpec& spec);

  /// Of a tuple of 2 or 3 reports of different sensors, nats; of less, 0.
  [[nodiscard]] double column(std::span<const SensorReport* const> reports) const;

  /// The greatest sum of squared distances from the mean, over s^2, with which a tuple of `reports`
  /// still has a negative cost; not positive if there is none.
  [[nodiscard]] double widest(int reports) const;

  /// c({z}), infinite (negative) without false alarms.
  [[nodiscard]] double alone() const;

  /// Squared distance over its variance if one target made both: chi-square, 2 degrees of freedom.
  [[nodiscard]] double distance(const SensorReport& a, const SensorReport& b) const;

 private:
  [[nodiscard]] double constant(int reports) const;

  double detection_;
  double missed_;
  double false_alarms_;  ///< lambda
  double lonely_;        ///< lambda + q
  double variance_;      ///< s^2
};

}  // namespace mda
