// What a simulated (or recorded) scene consists of: plots, scan by scan, and the truth behind them.
#pragma once

#include <vector>

namespace mda {

/// Kilometres and kilometres per second.
struct TargetState {
  double x = 0.0;
  double vx = 0.0;
  double y = 0.0;
  double vy = 0.0;
};

inline constexpr int kFalseAlarm = -1;

struct Plot {
  double range_km = 0.0;
  double bearing_rad = 0.0;  ///< in (-pi, pi], from the x axis towards the y axis
  int source = kFalseAlarm;  ///< target number; known to the metrics only
};

struct TruePosition {
  int target = 0;
  TargetState state;
};

/// One turn of the antenna. Plots are in the order of their range: no order tells of their source.
struct Scan {
  std::vector<Plot> plots;
  std::vector<TruePosition> truth;  ///< all targets that live, inside the coverage or not
};

struct Scene {
  std::vector<Scan> scans;
  int targets = 0;  ///< numbered from 0
};

}  // namespace mda
