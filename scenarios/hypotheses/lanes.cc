#include "scenarios/hypotheses/lanes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

// What keeps the loop below vectorised: no calls but sqrt, no branches, and the compiler flags
// -fno-math-errno and -fno-trapping-math. `scenarios_bench` shows when it is lost (a factor of 3).
#define MDA_INLINE [[gnu::always_inline]] inline

namespace mda {
namespace {

using std::numbers::pi;

/// sum of u^k / (2 k + 1), k = 0..11, signs alternating if Sign is -1: atan or atanh of sqrt(u),
/// over sqrt(u). Relative error below 2e-16 for u < 0.04.
template <int Sign>
MDA_INLINE double odd_series(double u) {
  double sum = 1.0 / 23.0;
#pragma GCC unroll 16
  for (int k = 10; k >= 0; --k) sum = 1.0 / (2 * k + 1) + Sign * u * sum;
  return sum;
}

/// atan2(y, x) to about 2e-16 rad, given r = hypot(x, y) > 0. The half angle tan(a / 2) =
/// min / (r + max) lies in [0, tan(pi / 8)]; turned back by pi / 16 it lies within tan(pi / 16),
/// where the series is short. One division.
MDA_INLINE double angle_of(double y, double x, double r) {
  constexpr double kTanSixteenth = 0.19891236737965800691;  // tan(pi / 16)
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  const double least = std::min(ax, ay);
  const double base = r + std::max(ax, ay);
  const double t = (least - kTanSixteenth * base) / (base + kTanSixteenth * least);
  double angle = pi / 8.0 + 2.0 * t * odd_series<-1>(t * t);
  angle = ay > ax ? pi / 2.0 - angle : angle;
  angle = x < 0.0 ? pi - angle : angle;
  return std::copysign(angle, y);
}

/// ln(v) for normal v > 0, to about 2e-16 of the larger of 1 and |ln v|: v = 2^e m with m in
/// [sqrt(1/2), sqrt(2)), and ln m = 2 atanh((m - 1) / (m + 1)).
MDA_INLINE double log_of(double v) {
  const auto bits = std::bit_cast<std::uint64_t>(v);
  // 2^52 + e in floating point, by its bits: there is no integer conversion in SSE2.
  constexpr std::uint64_t kTwoTo52 = 0x4330000000000000ULL;
  double e = std::bit_cast<double>(kTwoTo52 | (bits >> 52)) - (4503599627370496.0 + 1023.0);
  double m = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFULL) | 0x3FF0000000000000ULL);
  const bool upper = m > std::numbers::sqrt2;
  m = upper ? 0.5 * m : m;
  e = upper ? e + 1.0 : e;
  const double t = (m - 1.0) / (m + 1.0);
  return e * std::numbers::ln2 + 2.0 * t * odd_series<1>(t * t);
}

MDA_INLINE void predict_body(const LaneModel& model, double buckets_per_km, double last_bucket,
                             Lanes& a, int n) {
  for (int l = 0; l < n; ++l) {
    const double t = a.dt[l];
    const double x = a.x[0][l] + t * a.x[1][l];
    const double y = a.x[2][l] + t * a.x[3][l];
    // P = F P F' + Q; letters name the entry: x, u = vx, y, v = vy.
    const double uu = a.p[4][l], uv = a.p[6][l], vv = a.p[9][l];
    const double xu = a.p[1][l] + t * uu, xv = a.p[3][l] + t * uv;
    const double uy = a.p[5][l] + t * uv, yv = a.p[8][l] + t * vv;
    const double xx = a.p[0][l] + t * (a.p[1][l] + xu) + a.noise_pp[l];
    const double xy = a.p[2][l] + t * (a.p[3][l] + uy);
    const double yy = a.p[7][l] + t * (a.p[8][l] + yv) + a.noise_pp[l];
    const double p[10] = {xx,
                          xu + a.noise_pv[l],
                          xy,
                          xv,
                          uu + a.noise_vv[l],
                          uy,
                          uv,
                          yy,
                          yv + a.noise_pv[l],
                          vv + a.noise_vv[l]};

    // h and its Jacobian: range along (c, s), bearing along (-s, c) / r.
    const double r = std::sqrt(x * x + y * y + 1e-24);
    const double inverse_r = 1.0 / r;
    const double c = x * inverse_r, s = y * inverse_r;
    const double bc = c * inverse_r, bs = -s * inverse_r;
    const double to_range[4] = {p[0] * c + p[2] * s, p[1] * c + p[5] * s, p[2] * c + p[7] * s,
                                p[3] * c + p[8] * s};
    const double to_bearing[4] = {p[0] * bs + p[2] * bc, p[1] * bs + p[5] * bc,
                                  p[2] * bs + p[7] * bc, p[3] * bs + p[8] * bc};
    const double b_rr = c * to_range[0] + s * to_range[2] + model.range_variance;
    const double b_rb = bs * to_range[0] + bc * to_range[2];
    const double b_bb = bs * to_bearing[0] + bc * to_bearing[2] + model.bearing_variance;
    const double determinant = b_rr * b_bb - b_rb * b_rb;
    const double inverse = 1.0 / determinant;
    const double i_rr = b_bb * inverse, i_rb = -b_rb * inverse, i_bb = b_rr * inverse;

    a.x[0][l] = x;
    a.x[2][l] = y;
    a.range[l] = r;
    a.bearing[l] = angle_of(y, x, r);
    a.inverse_rr[l] = i_rr;
    a.inverse_rb[l] = i_rb;
    a.inverse_bb[l] = i_bb;
    a.cost[l] = model.detection_cost + 0.5 * log_of(determinant);

    double k_r[4], k_b[4];
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) {
      k_r[i] = to_range[i] * i_rr + to_bearing[i] * i_rb;
      k_b[i] = to_range[i] * i_rb + to_bearing[i] * i_bb;
      a.gain_range[i][l] = k_r[i];
      a.gain_bearing[i][l] = k_b[i];
    }
#pragma GCC unroll 4
    for (int i = 0, entry = 0; i < 4; ++i) {
#pragma GCC unroll 4
      for (int j = i; j < 4; ++j, ++entry) {
        a.updated[entry][l] = p[entry] - (k_r[i] * to_range[j] + k_b[i] * to_bearing[j]);
      }
    }

    const double half_gate = std::sqrt(model.gate * b_rr);
    const double first = std::max((r - half_gate) * buckets_per_km, 0.0);
    const double end = (r + half_gate) * buckets_per_km + 1.0;
    a.first_bucket[l] = static_cast<int>(std::min(first, last_bucket));
    a.end_bucket[l] = static_cast<int>(std::min(end, last_bucket));
  }
}

void predict_baseline(const LaneModel& model, double buckets_per_km, double last_bucket,
                      Lanes& lanes, int n) {
  predict_body(model, buckets_per_km, last_bucket, lanes, n);
}

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] void predict_avx2(const LaneModel& model, double buckets_per_km,
                                              double last_bucket, Lanes& lanes, int n) {
  predict_body(model, buckets_per_km, last_bucket, lanes, n);
}
#endif

}  // namespace

PredictLanes predict_lanes_for_this_cpu() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return predict_avx2;
#endif
  return predict_baseline;
}

PredictLanes predict_lanes_baseline() noexcept { return predict_baseline; }

}  // namespace mda
