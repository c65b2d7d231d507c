#include "scenarios/testing/by_the_book.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// A filter on its own, in the information form, and the costs as the paper writes them.
class StraightFilter {
 public:
  explicit StraightFilter(const ScenarioSpec& spec, const Gaussian& base)
      : spec_(spec), mean_(base.mean), covariance_(base.covariance) {}

  void predict() {
    const double t = spec_.world.scan_period_s;
    const double q = spec_.world.acceleration_sigma_km_s2;
    Eigen::Matrix4d f = Eigen::Matrix4d::Identity();
    f(0, 1) = f(2, 3) = t;
    Eigen::Matrix<double, 4, 2> b;
    b << 0.5 * t * t, 0.0, t, 0.0, 0.0, 0.5 * t * t, 0.0, t;
    mean_ = f * mean_;
    covariance_ = f * covariance_ * f.transpose() + q * q * b * b.transpose();
  }

  /// Squared distance and density of a plot.
  std::pair<double, double> look(const Eigen::Vector3d& z) {
    const double r = std::hypot(mean_(0), mean_(2));
    const double rate = (mean_(0) * mean_(1) + mean_(2) * mean_(3)) / r;
    h_.setZero();
    h_(0, 0) = h_(2, 1) = mean_(0) / r;
    h_(0, 2) = h_(2, 3) = mean_(2) / r;
    h_(1, 0) = -mean_(2) / (r * r);
    h_(1, 2) = mean_(0) / (r * r);
    h_(2, 0) = mean_(1) / r - mean_(0) * rate / (r * r);
    h_(2, 2) = mean_(3) / r - mean_(2) * rate / (r * r);
    nu_ = z - Eigen::Vector3d(r, std::atan2(mean_(2), mean_(0)), rate);
    const Eigen::Vector3d sigmas(spec_.world.range_sigma_km, spec_.world.bearing_sigma_rad,
                                 spec_.known_targets->range_rate_sigma_km_s);
    noise_ = sigmas.cwiseAbs2().asDiagonal();
    const Eigen::Matrix3d s = h_ * covariance_ * h_.transpose() + noise_;
    const double d2 = nu_.dot(s.llt().solve(nu_));
    return {d2, std::exp(-0.5 * d2) /
                    std::sqrt(std::pow(2.0 * std::numbers::pi, 3.0) * s.determinant())};
  }

  /// With the plot of the last look.
  void update() {
    const Eigen::Matrix<double, 4, 3> weighted = h_.transpose() * noise_.inverse();
    covariance_ = (covariance_.inverse() + weighted * h_).inverse();
    mean_ += covariance_ * weighted * nu_;
  }

 private:
  ScenarioSpec spec_;
  Eigen::Vector4d mean_;
  Eigen::Matrix4d covariance_;
  Eigen::Matrix<double, 3, 4> h_;
  Eigen::Matrix3d noise_;
  Eigen::Vector3d nu_;
};

/// All rows' plots; nothing for the tracks.
std::vector<Eigen::Vector3d> plots_of_rows(const KnownTrackWindows& windows) {
  std::vector<Eigen::Vector3d> plots(index(windows.tracks()));
  for (int k = 1; k <= windows.window_scans(); ++k) {
    const int scan = windows.newest_scan() - windows.window_scans() + k;
    for (const DopplerPlot& plot : windows.scene().scans[index(scan - 1)].plots) {
      plots.push_back(measurement_of(plot));
    }
  }
  return plots;
}

using Visit = std::function<void(const Tuple&, double)>;

class ByTheBook {
 public:
  ByTheBook(const ScenarioSpec& spec, const KnownTrackWindows& windows)
      : spec_(spec),
        windows_(windows),
        plots_(plots_of_rows(windows)),
        density_(spec.world.clutter_per_scan / windows.scene().clutter_box.volume()) {}

  /// Visits all gated sequences of all tracks: visit(tuple, cost).
  void every_sequence(const Visit& visit) const {
    for (int track = 0; track < windows_.tracks(); ++track) {
      Tuple tuple{track, {}};
      extend(tuple, StraightFilter(spec_, windows_.scene().initial[index(track)]), 0.0, visit);
    }
  }

 private:
  void extend(Tuple& tuple, StraightFilter filter, double cost, const Visit& visit) const {
    const int k = static_cast<int>(tuple.rows.size()) + 1;
    if (k > windows_.window_scans()) {
      visit(tuple, cost);
      return;
    }
    filter.predict();
    for (int row = windows_.tracks(); row < static_cast<int>(plots_.size()); ++row) {
      if (windows_.window().problem.dimension(row) != k) continue;
      const auto [d2, likelihood] = filter.look(plots_[index(row)]);
      if (d2 > spec_.model.gate) continue;
      StraightFilter next = filter;
      next.update();
      tuple.rows.push_back(row);
      extend(tuple, next,
             cost - std::log(spec_.world.detection_probability * likelihood / density_), visit);
      tuple.rows.pop_back();
    }
    tuple.rows.push_back(kNoRow);
    extend(tuple, filter, cost - std::log(1.0 - spec_.world.detection_probability), visit);
    tuple.rows.pop_back();
  }

  ScenarioSpec spec_;
  const KnownTrackWindows& windows_;
  std::vector<Eigen::Vector3d> plots_;
  double density_;
};

}  // namespace

void every_gated_sequence(const ScenarioSpec& spec, const KnownTrackWindows& windows,
                          const std::function<void(const Tuple&, double)>& visit) {
  ByTheBook(spec, windows).every_sequence(visit);
}

}  // namespace mda::testing
