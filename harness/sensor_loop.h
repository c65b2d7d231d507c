// The one window of three sensors at one instant.
#pragma once

#include <optional>

#include "harness/window_loop.h"
#include "scenarios/static3/sensor_scene.h"

namespace mda {

/// K is 3, the number of sensors, and the window is that of scan 1: there is nothing to advance.
class SensorLoop final : public WindowLoop {
 public:
  void start(const ScenarioSpec& spec, std::uint64_t seed, int replicate, int window_k,
             bool views) override;
  bool next() override;
  void advance(const Decision& /*decision*/) override {}
  [[nodiscard]] int scan() const noexcept override { return done_ ? 1 : 0; }
  /// Of the targets that two sensors at least have seen.
  [[nodiscard]] std::optional<double> truth_cost() const override { return truth_cost_; }
  [[nodiscard]] std::optional<AssociationCounts> association(
      const Solution& solution) const override;

 private:
  ScenarioSpec spec_;
  SensorScene scene_;
  bool views_ = false;
  bool done_ = false;
  double truth_cost_ = 0.0;
  TrueAssociation truth_;
};

}  // namespace mda
