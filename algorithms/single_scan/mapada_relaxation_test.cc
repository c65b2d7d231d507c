#include "algorithms/single_scan/mapada_relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "algorithms/testing/draw.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Every pair exists, half of them in the gate, at up to 0.4 km^2 as in a gate of the paper.
MapadaCluster dense_cluster(int m, int n, std::uint64_t seed) {
  testing::Draw draw(seed);
  MapadaCluster cluster;
  cluster.targets = n;
  for (int j = 0; j < m; ++j) {
    cluster.add_measurement();
    for (int t = 1; t <= n; ++t) cluster.add_pair(t, 0.4 * draw.unit(), draw.chance(0.5));
  }
  return cluster;
}

/// Double centring. With W = Omega - c / alpha, its sums over rows R_j, over columns S_t and over
/// all of them G, the limit of equation (16) is
///   W_jt + (1 - R_j) / (n + 1) + (s_t - S_t) / m - (m - G) / ((n + 1) m).
std::vector<double> closed_form(const MapadaCluster& cluster, double alpha) {
  const int m = cluster.measurements();
  const int n = cluster.targets;
  std::vector<double> w(cluster.c.size());
  std::vector<double> row(index(m), 0.0);
  std::vector<double> column(index(n) + 1, 0.0);
  for (int j = 0; j < m; ++j) {
    for (int t = 0; t <= n; ++t) {
      const std::size_t k = index(j * (n + 1) + t);
      w[k] = cluster.gate[k] - cluster.c[k] / alpha;
      row[index(j)] += w[k];
      column[index(t)] += w[k];
    }
  }
  const double all = std::accumulate(row.begin(), row.end(), 0.0);
  for (int j = 0; j < m; ++j) {
    for (int t = 0; t <= n; ++t) {
      const double supply = t > 0 ? 1.0 : m - n;
      w[index(j * (n + 1) + t)] += (1.0 - row[index(j)]) / (n + 1) +
                                   (supply - column[index(t)]) / m -
                                   (m - all) / (static_cast<double>(n + 1) * m);
    }
  }
  return w;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

struct Size {
  int m;
  int n;
};

constexpr Size kSizes[] = {{1, 1}, {2, 1}, {3, 2}, {4, 4}, {5, 4}, {8, 4}, {9, 3}, {12, 10}};

MapadaIteration unclipped(double alpha, double step) {
  return {.alpha = alpha, .step = step, .tolerance = 1e-7, .iterations = 20000, .clip = false};
}

TEST(MapadaRelaxation, ItsLimitIsTheClosedForm) {
  for (const Size& size : kSizes) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(::testing::Message() << size.m << " " << size.n << " " << seed);
      const MapadaCluster cluster = dense_cluster(size.m, size.n, seed);
      for (const double alpha : {1.0, 2.0, 5.0}) {
        const MapadaPoint point = mapada_relaxation(cluster, unclipped(alpha, 0.5), Budget{});
        ASSERT_EQ(point.stop, Stop::kFinished);
        EXPECT_LE(largest_difference(point.omega, closed_form(cluster, alpha)), 1e-5);
      }
    }
  }
}

/// The paper says that the minimum next to the start is found. There is only one.
TEST(MapadaRelaxation, TheStartDoesNotMatter) {
  for (const bool clip : {false, true}) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      SCOPED_TRACE(seed);
      const MapadaCluster cluster = dense_cluster(5, 4, seed);
      MapadaIteration options = unclipped(1.0, 0.5);
      options.clip = clip;
      const MapadaPoint first = mapada_relaxation(cluster, options, Budget{});
      testing::Draw draw(seed);
      std::vector<double> start(cluster.c.size());
      for (double& value : start) value = 3.0 * draw.unit();
      const MapadaPoint second = mapada_relaxation(cluster, options, Budget{}, start);
      ASSERT_EQ(first.stop, Stop::kFinished);
      ASSERT_EQ(second.stop, Stop::kFinished);
      EXPECT_LE(largest_difference(first.omega, second.omega), 1e-5);
    }
  }
}

TEST(MapadaRelaxation, SettlesBelowTheStepBoundAndNotAbove) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    const MapadaCluster cluster = dense_cluster(8, 4, seed);
    const std::vector<double> limit = closed_form(cluster, 5.0);
    const MapadaPoint below = mapada_relaxation(cluster, unclipped(5.0, 0.9), Budget{});
    EXPECT_EQ(below.stop, Stop::kFinished);
    EXPECT_LE(largest_difference(below.omega, limit), 1e-5);
    const MapadaPoint above = mapada_relaxation(cluster, unclipped(5.0, 1.05), Budget{});
    EXPECT_EQ(above.stop, Stop::kIterationLimit);
    EXPECT_FALSE(largest_difference(above.omega, limit) < 1.0);
  }
}

/// Clipped, it is the optimum of the same energy over what is not negative: rows and columns add
/// up, and (up to constants along rows and columns) the slope is 0 where omega is positive and not
/// negative where it is 0. Cycles of pairs see no such constants, so the energy rises along each of
/// the four-pair cycles that keep omega at or above 0.
TEST(MapadaRelaxation, ClippedItIsTheOptimumAboveZero) {
  int at_zero = 0;
  const double alpha = 1.0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    const MapadaCluster cluster = dense_cluster(6, 4, seed);
    MapadaIteration options = unclipped(alpha, 0.5);
    options.clip = true;
    const MapadaPoint point = mapada_relaxation(cluster, options, Budget{});
    ASSERT_EQ(point.stop, Stop::kFinished);
    const auto at = [&](int j, int t) { return index(j * 5 + t); };
    const auto slope = [&](std::size_t k) {
      return cluster.c[k] + alpha * (point.omega[k] - cluster.gate[k]);
    };
    for (int j = 0; j < 6; ++j) {
      double sum = 0.0;
      for (int t = 0; t <= 4; ++t) {
        const double w = point.omega[at(j, t)];
        EXPECT_GE(w, 0.0);
        at_zero += w == 0.0 ? 1 : 0;
        sum += w;
      }
      EXPECT_NEAR(sum, 1.0, 1e-6);
    }
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        for (int s = 0; s <= 4; ++s) {
          for (int t = 0; t <= 4; ++t) {
            if (i == j || s == t) continue;
            if (point.omega[at(i, s)] == 0.0 || point.omega[at(j, t)] == 0.0) continue;
            EXPECT_GE(slope(at(i, t)) + slope(at(j, s)) - slope(at(i, s)) - slope(at(j, t)), -1e-5);
          }
        }
      }
    }
  }
  EXPECT_GE(at_zero, 50);
}

/// Over all ways to give every target a measurement of its own, the least energy without its
/// constant: sum of c + alpha/2 (1 - 2 Omega).
class LeastEnergy {
 public:
  LeastEnergy(const MapadaCluster& cluster, double alpha)
      : cluster_(cluster), alpha_(alpha), taken_(index(cluster.measurements()), 0) {}

  [[nodiscard]] double of(const std::vector<int>& measurement) const {
    std::vector<int> origin(taken_.size(), 0);
    for (std::size_t t = 0; t < measurement.size(); ++t) {
      origin[index(measurement[t])] = static_cast<int>(t) + 1;
    }
    double energy = 0.0;
    for (std::size_t j = 0; j < origin.size(); ++j) {
      const std::size_t k = j * index(cluster_.targets + 1) + index(origin[j]);
      energy += cluster_.c[k] + 0.5 * alpha_ * (1.0 - 2.0 * cluster_.gate[k]);
    }
    return energy;
  }

  double over_all() {
    if (chosen_.size() == index(cluster_.targets)) return of(chosen_);
    double least = std::numeric_limits<double>::infinity();
    for (int j = 0; j < cluster_.measurements(); ++j) {
      if (taken_[index(j)] != 0) continue;
      taken_[index(j)] = 1;
      chosen_.push_back(j);
      least = std::min(least, over_all());
      chosen_.pop_back();
      taken_[index(j)] = 0;
    }
    return least;
  }

 private:
  const MapadaCluster& cluster_;
  double alpha_;
  std::vector<char> taken_;
  std::vector<int> chosen_;
};

TEST(MapadaRelaxation, AssignmentOnTheUnclippedLimitIsTheLeastEnergy) {
  int argmax_conflicts = 0;
  for (const Size& size : {Size{1, 1}, Size{3, 2}, Size{4, 4}, Size{6, 3}}) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      SCOPED_TRACE(::testing::Message() << size.m << " " << size.n << " " << seed);
      const MapadaCluster cluster = dense_cluster(size.m, size.n, seed);
      for (const double alpha : {0.02, 0.2, 1.0, 5.0}) {
        const std::vector<double> limit = closed_form(cluster, alpha);
        LeastEnergy energy(cluster, alpha);
        EXPECT_NEAR(energy.of(assign_by_omega(cluster, limit)), energy.over_all(), 1e-9);
        std::vector<int> argmax = largest_omega(cluster, limit);
        std::sort(argmax.begin(), argmax.end());
        argmax_conflicts +=
            std::adjacent_find(argmax.begin(), argmax.end()) != argmax.end() ? 1 : 0;
      }
    }
  }
  EXPECT_GE(argmax_conflicts, 100) << "the clusters are too easy to tell the decisions apart";
}

TEST(MapadaRelaxation, ATargetWithoutAMeasurementIsAnError) {
  const MapadaCluster cluster = dense_cluster(2, 3, 1);
  EXPECT_THROW((void)assign_by_omega(cluster, cluster.gate), std::invalid_argument);
}

}  // namespace
}  // namespace mda
