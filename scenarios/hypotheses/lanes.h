// The filter's arithmetic for many tracks at once. One block of lanes is the only structure of
// arrays in the program: plain loops over it are what the compiler vectorises.
#pragma once

#include "scenarios/spec.h"

namespace mda {

inline constexpr int kLanes = 64;

/// Constants of the sensor and the gate, in the form that the kernel uses.
struct LaneModel {
  double range_variance = 0.0;    ///< km^2
  double bearing_variance = 0.0;  ///< rad^2
  double detection_cost = 0.0;    ///< CostTerms::detection, nats
  double gate = 0.0;              ///< eta^2
};

/// The state (x, vx, y, vy) right after the last plot; the covariance's upper triangle row by row.
struct LaneState {
  double x[4];
  double p[10];
};

/// One lane per track. Lengths in km, angles in rad, times in s, costs in nats.
struct alignas(64) Lanes {
  // In: the state after the last plot, the time since, and the process noise of an axis over it.
  double x[4][kLanes];
  double p[10][kLanes];
  double dt[kLanes];
  double noise_pp[kLanes], noise_pv[kLanes], noise_vv[kLanes];

  // Out: x is the predicted state; the expected plot; the inverse innovation covariance B^-1; the
  // cost of a detection but for d^2 / 2 and the plot's ln f_phi; the Kalman gain's two columns;
  // the covariance after an update; the plots' buckets that the gate reaches.
  double range[kLanes], bearing[kLanes];
  double inverse_rr[kLanes], inverse_rb[kLanes], inverse_bb[kLanes];
  double cost[kLanes];
  double gain_range[4][kLanes], gain_bearing[4][kLanes];
  double updated[10][kLanes];
  int first_bucket[kLanes], end_bucket[kLanes];

  void put(int lane, const LaneState& state) noexcept {
    for (int i = 0; i < 4; ++i) x[i][lane] = state.x[i];
    for (int i = 0; i < 10; ++i) p[i][lane] = state.p[i];
  }
};

/// Predicts lanes 0 to n - 1 and prepares their gates. `n` <= kLanes. No branch depends on data; a
/// range of 0 counts as 1e-12 km. The bits of the result are the same on every x86-64 processor.
using PredictLanes = void (*)(const LaneModel& model, double buckets_per_km, double last_bucket,
                              Lanes& lanes, int n);

/// The fastest version for this processor: AVX2 or the baseline (SSE2).
[[nodiscard]] PredictLanes predict_lanes_for_this_cpu() noexcept;

/// The baseline version, which every processor has.
[[nodiscard]] PredictLanes predict_lanes_baseline() noexcept;

}  // namespace mda
