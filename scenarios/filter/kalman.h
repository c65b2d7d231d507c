// The Kalman update, whatever is measured.
#pragma once

#include <Eigen/Dense>

#include "scenarios/filter/ekf.h"

namespace mda {

/// The Kalman update with innovation `nu` of `measurement_size` numbers, the measurement's Jacobian
/// and the inverse of the innovation's covariance. The result is made symmetric again: what
/// rounding leaves of asymmetry grows from scan to scan, to 1e-9 nats in 20 updates.
template <int measurement_size>
[[nodiscard]] Gaussian kalman_update(
    const Gaussian& predicted, const Eigen::Matrix<double, measurement_size, 1>& nu,
    const Eigen::Matrix<double, measurement_size, 4>& jacobian,
    const Eigen::Matrix<double, measurement_size, measurement_size>& inverse) {
  const Eigen::Matrix<double, 4, measurement_size> cross =
      predicted.covariance * jacobian.transpose();
  const Eigen::Matrix<double, 4, measurement_size> gain = cross * inverse;
  const Eigen::Matrix4d reduced = predicted.covariance - gain * cross.transpose();
  return {predicted.mean + gain * nu, 0.5 * (reduced + reduced.transpose())};
}

}  // namespace mda
