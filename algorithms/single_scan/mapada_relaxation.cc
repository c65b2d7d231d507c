#include "algorithms/single_scan/mapada_relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "algorithms/backends/assignment.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kIterationsPerLookAtTheClock = 64;
constexpr double kDiverged = 1e100;

std::vector<double> normalised_gate(const MapadaCluster& cluster) {
  std::vector<double> omega = cluster.gate;
  for (int j = 0; j < cluster.measurements(); ++j) {
    const auto first = omega.begin() + cluster.pair_begin[index(j)];
    const auto last = omega.begin() + cluster.pair_begin[index(j) + 1];
    double sum = 0.0;
    for (auto w = first; w != last; ++w) sum += *w;
    for (auto w = first; w != last; ++w) *w /= sum;
  }
  return omega;
}

/// The state (omega, lambda, epsilon) and its steps.
class Relaxation {
 public:
  Relaxation(const MapadaCluster& cluster, const MapadaIteration& options,
             std::vector<double> omega)
      : cluster_(cluster),
        options_(options),
        dt_(options.step *
            mapada_step_bound(options.alpha, cluster.measurements(), cluster.targets)),
        omega_(std::move(omega)),
        pull_(cluster.c),
        lambda_(index(cluster.targets) + 1, 0.0),
        epsilon_(index(cluster.measurements()), 0.0),
        column_sum_(lambda_.size()) {
    for (std::size_t k = 0; k < pull_.size(); ++k) pull_[k] -= options.alpha * cluster.gate[k];
  }

  MapadaPoint run(const Budget& budget) {
    MapadaPoint point;
    point.stop = Stop::kIterationLimit;
    while (point.iterations < options_.iterations) {
      if (point.iterations % kIterationsPerLookAtTheClock == 0 && budget.expired()) {
        point.stop = Stop::kDeadline;
        break;
      }
      ++point.iterations;
      const double change = advance();
      if (change > kDiverged) break;
      if (change < options_.tolerance * dt_) {
        point.stop = Stop::kFinished;
        break;
      }
    }
    point.omega = std::move(omega_);
    return point;
  }

 private:
  /// Returns the largest change.
  double advance() {
    double change = 0.0;
    std::fill(column_sum_.begin(), column_sum_.end(), 0.0);
    for (std::size_t j = 0; j < epsilon_.size(); ++j) change = std::max(change, advance_row(j));
    for (std::size_t t = 0; t < lambda_.size(); ++t) {
      const double supply = t > 0 ? 1.0 : cluster_.measurements() - cluster_.targets;
      const double slope = column_sum_[t] - supply;
      lambda_[t] += dt_ * slope;
      change = std::max(change, std::abs(dt_ * slope));
    }
    return change;
  }

  double advance_row(std::size_t j) {
    double change = 0.0;
    double row_sum = 0.0;
    const auto last = index(cluster_.pair_begin[j + 1]);
    for (auto k = index(cluster_.pair_begin[j]); k < last; ++k) {
      const auto t = index(cluster_.t[k]);
      const double before = omega_[k];
      const double slope = pull_[k] + options_.alpha * before + lambda_[t] + epsilon_[j];
      const double moved = before - dt_ * slope;
      omega_[k] = options_.clip ? std::max(0.0, moved) : moved;
      change = std::max(change, std::abs(omega_[k] - before));
      row_sum += before;
      column_sum_[t] += before;
    }
    epsilon_[j] += dt_ * (row_sum - 1.0);
    return std::max(change, std::abs(dt_ * (row_sum - 1.0)));
  }

  const MapadaCluster& cluster_;
  MapadaIteration options_;
  double dt_;
  std::vector<double> omega_;
  std::vector<double> pull_;  ///< c - alpha Omega
  std::vector<double> lambda_;
  std::vector<double> epsilon_;
  std::vector<double> column_sum_;
};

/// What a target pays for a measurement: minus omega, and that the clutter does without it.
SparseCosts costs_of(const MapadaCluster& cluster, std::span<const double> omega) {
  SparseCosts costs;
  costs.columns = cluster.measurements();
  costs.alone.assign(index(cluster.targets), std::numeric_limits<double>::infinity());
  costs.row_begin.assign(index(cluster.targets) + 2, 0);
  for (const int t : cluster.t) ++costs.row_begin[index(t) + 1];
  costs.row_begin[1] = 0;  // the clutter needs no measurement
  for (std::size_t t = 1; t < costs.row_begin.size(); ++t) {
    costs.row_begin[t] += costs.row_begin[t - 1];
  }
  std::vector<int> next(costs.row_begin.begin(), costs.row_begin.end() - 1);
  costs.column.resize(index(costs.row_begin.back()));
  costs.cost.resize(costs.column.size());
  for (int j = 0; j < cluster.measurements(); ++j) {
    const int clutter = cluster.pair_begin[index(j)];
    for (int k = clutter + 1; k < cluster.pair_begin[index(j) + 1]; ++k) {
      const auto entry = index(next[index(cluster.t[index(k)])]++);
      costs.column[entry] = j;
      costs.cost[entry] = omega[index(clutter)] - omega[index(k)];
    }
  }
  costs.row_begin.erase(costs.row_begin.begin());
  return costs;
}

}  // namespace

void MapadaCluster::add_measurement() {
  pair_begin.push_back(pair_begin.back());
  add_pair(0, 0.0, true);
}

void MapadaCluster::add_pair(int target, double cost, bool in_gate) {
  t.push_back(target);
  c.push_back(cost);
  gate.push_back(in_gate ? 1.0 : 0.0);
  ++pair_begin.back();
}

double mapada_step_bound(double alpha, int measurements, int targets) {
  return std::min(2.0 / alpha, alpha / (measurements + targets + 1));
}

MapadaPoint mapada_relaxation(const MapadaCluster& cluster, const MapadaIteration& options,
                              const Budget& budget, std::span<const double> start) {
  std::vector<double> omega =
      start.empty() ? normalised_gate(cluster) : std::vector<double>(start.begin(), start.end());
  return Relaxation(cluster, options, std::move(omega)).run(budget);
}

std::vector<int> assign_by_omega(const MapadaCluster& cluster, std::span<const double> omega) {
  AssignmentSolver solver;
  const Assignment& assignment = solver.solve(costs_of(cluster, omega));
  if (!assignment.feasible) throw std::invalid_argument("fewer measurements than targets");
  return assignment.column_of_row;
}

std::vector<int> largest_omega(const MapadaCluster& cluster, std::span<const double> omega) {
  std::vector<int> best(index(cluster.targets), -1);
  std::vector<double> value(best.size(), -std::numeric_limits<double>::infinity());
  for (int j = 0; j < cluster.measurements(); ++j) {
    for (int k = cluster.pair_begin[index(j)] + 1; k < cluster.pair_begin[index(j) + 1]; ++k) {
      const auto target = index(cluster.t[index(k)]) - 1;
      if (omega[index(k)] <= value[target]) continue;
      value[target] = omega[index(k)];
      best[target] = j;
    }
  }
  return best;
}

}  // namespace mda
