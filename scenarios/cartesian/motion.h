// How a filter takes targets to move between two scans: the two models of Lee & Jeong 1998.
#pragma once

#include <Eigen/Dense>

#include "scenarios/spec.h"

namespace mda {

/// Position, velocity and acceleration of the x axis, then of the y axis: km and s.
using MotionVector = Eigen::Matrix<double, 6, 1>;
using MotionMatrix = Eigen::Matrix<double, 6, 6>;

/// One scan period of a linear motion, the axes apart from each other and alike.
struct MotionModel {
  MotionMatrix transition;
  MotionMatrix noise;                  ///< covariance of what is added
  double acceleration_variance = 0.0;  ///< of an axis at the start, (km/s^2)^2
};

/// Equation (17): constant velocity but for an acceleration drawn for every scan period, with
/// world.acceleration_sigma_km_s2 on each axis. The acceleration of the state stays 0.
[[nodiscard]] MotionModel constant_velocity(const World& world);

/// Acceleration as a first-order Markov process of that standard deviation and time constant > 0;
/// Singer, "Estimating optimal tracking filter performance for manned maneuvering targets", IEEE
/// Transactions on Aerospace and Electronic Systems 6 (1970).
[[nodiscard]] MotionModel singer(double scan_period_s, double acceleration_sigma_km_s2,
                                 double time_s);

}  // namespace mda
