#include "scenarios/known/known_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/testing/tree_laws.h"
#include "scenarios/groups.h"
#include "scenarios/known/references.h"
#include "scenarios/testing/known.h"

namespace mda::testing {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Scan counts that end amid what is hard: platoons in each other, the first meeting.
int hard_scans(const ScenarioSpec& spec) {
  return spec.known_targets->trajectories == Trajectories::kPlatoons ? 36 : 84;
}

/// Plays a run by the truth and calls see(windows, true sequences) for every window.
template <typename See>
void for_every_window(const ScenarioSpec& spec, int window_k, See see) {
  KnownTrackWindows windows(spec, kSeed, 1, window_k);
  while (windows.next()) {
    const std::vector<Tuple> tuples = true_sequences(windows);
    see(windows, tuples);
    windows.advance(tuples);
  }
}

TEST(KnownWindowsTest, TreesObeyTheirLaws) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    for (int window_k = 1; window_k <= 4; ++window_k) {
      SCOPED_TRACE(spec.name + ", K = " + std::to_string(window_k));
      int seen = 0;
      for_every_window(cut_short(spec, hard_scans(spec)), window_k,
                       [&](const KnownTrackWindows& windows, const auto&) {
                         ++seen;
                         ASSERT_EQ(windows.window_scans(), std::min(seen, window_k));
                         ASSERT_EQ(windows.newest_scan(), seen);
                         if (seen % 4 != 0 && seen > window_k) return;
                         const AssociationProblem& problem = windows.window().problem;
                         expect_lawful_tree(problem);
                         expect_tuple_cost_of_columns(problem, 1e-9);
                       });
      EXPECT_EQ(seen, hard_scans(spec));
    }
  }
}

TEST(KnownWindowsTest, ShapeIsThatOfKnownTracks) {
  for_every_window(
      cut_short(*find_scenario("battistelli-1"), 12), 3,
      [](const KnownTrackWindows& windows, const auto&) {
        const Shape& shape = windows.window().problem.shape();
        EXPECT_TRUE(shape.known_tracks);
        EXPECT_TRUE(shape.has_tree);
        EXPECT_TRUE(shape.always_feasible);
        EXPECT_EQ(shape.dimensions, windows.window_scans() + 1);
        double ungated = windows.tracks();
        int rows = windows.tracks();
        for (int k = 0; k < windows.window_scans(); ++k) {
          const auto& scan = windows.scene().scans[index(windows.newest_scan() - 1 - k)];
          ungated *= static_cast<double>(scan.plots.size() + 1);
          rows += static_cast<int>(scan.plots.size());
        }
        EXPECT_EQ(shape.rows, rows);
        EXPECT_EQ(windows.window().ungated_columns, ungated);
        const std::vector<double> coasting = coasting_costs(windows.window().problem);
        for (int row = 0; row < rows; ++row) {
          const auto use = windows.window().problem.use(row);
          EXPECT_EQ(use, row < windows.tracks() ? RowUse::kExactlyOnce : RowUse::kAtMostOnce);
        }
        EXPECT_EQ(static_cast<int>(coasting.size()), rows);
      });
}

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

/// Costs by the book, and how many sequences pass the gate test plot by plot: all are columns.
class ByTheBook {
 public:
  ByTheBook(const ScenarioSpec& spec, const KnownTrackWindows& windows)
      : spec_(spec),
        windows_(windows),
        plots_(plots_of_rows(windows)),
        density_(20.0 / windows.scene().clutter_box.volume()) {}

  /// Visits all gated sequences of all tracks: visit(tuple, cost).
  template <typename Visit>
  void every_sequence(Visit visit) const {
    for (int track = 0; track < windows_.tracks(); ++track) {
      Tuple tuple{track, {}};
      extend(tuple, StraightFilter(spec_, windows_.scene().initial[index(track)]), 0.0, visit);
    }
  }

 private:
  template <typename Visit>
  void extend(Tuple& tuple, StraightFilter filter, double cost, Visit visit) const {
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
      extend(tuple, next, cost - std::log(0.8 * likelihood / density_), visit);
      tuple.rows.pop_back();
    }
    tuple.rows.push_back(kNoRow);
    extend(tuple, filter, cost - std::log(0.2), visit);
    tuple.rows.pop_back();
  }

  ScenarioSpec spec_;
  const KnownTrackWindows& windows_;
  std::vector<Eigen::Vector3d> plots_;
  double density_;
};

/// The first windows, whose base is the given estimate.
TEST(KnownWindowsTest, ColumnsAreAllGatedSequencesAtTheirCost) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    SCOPED_TRACE(spec.name);
    KnownTrackWindows windows(spec, kSeed, 2, 4);
    for (int scan = 1; scan <= 4; ++scan) {
      ASSERT_TRUE(windows.next());
      const AssociationProblem& problem = windows.window().problem;
      std::map<std::pair<int, std::vector<int>>, double> costs;
      std::vector<int> columns(index(problem.columns()));
      std::iota(columns.begin(), columns.end(), 0);
      const std::vector<Tuple> sequences = windows.sequences_of(columns);
      for (int j = 0; j < problem.columns(); ++j) {
        costs[{sequences[index(j)].track, sequences[index(j)].rows}] = problem.cost(j);
      }
      std::size_t count = 0;
      ByTheBook(spec, windows).every_sequence([&](const Tuple& tuple, double cost) {
        ++count;
        const auto found = costs.find({tuple.track, tuple.rows});
        ASSERT_NE(found, costs.end());
        EXPECT_NEAR(found->second, cost, 1e-7);
        EXPECT_NEAR(problem.views()->tuple_cost(tuple), cost, 1e-7);
      });
      EXPECT_EQ(count, costs.size());
      windows.advance(true_sequences(windows));
      EXPECT_EQ(windows.fixed_scan(), scan < 4 ? 0 : 1);
    }
  }
}

struct Totals {
  double true_plot = 0.0;        ///< mean cost of a target's own plot, beyond that of a miss
  double miss_is_cheaper = 0.0;  ///< share of windows in which all-missed beats the truth
};

Totals totals_of(const char* name, CostNormalisation normalisation) {
  ScenarioSpec spec = *find_scenario(name);
  spec.known_targets->normalisation = normalisation;
  Totals totals;
  double plots = 0.0;
  double number = 0.0;
  for_every_window(spec, 2, [&](const KnownTrackWindows& windows, const auto& tuples) {
    const TupleCost& cost = windows.window().problem.views()->tuple_cost;
    double true_total = 0.0;
    for (const Tuple& tuple : tuples) {
      const Tuple missed{tuple.track, std::vector<int>(tuple.rows.size(), kNoRow)};
      true_total += cost(tuple) - cost(missed);
      for (const int row : tuple.rows) plots += row == kNoRow ? 0.0 : 1.0;
    }
    totals.true_plot += true_total;
    totals.miss_is_cheaper += true_total > 0.0 ? 1.0 : 0.0;
    number += 1.0;
  });
  totals.true_plot /= plots;
  totals.miss_is_cheaper /= number;
  return totals;
}

/// Why the likelihood is divided by the density of clutter.
TEST(KnownWindowsTest, OnlyARatioOfLikelihoodsPrefersTheTruth) {
  for (const char* name : {"battistelli-1", "battistelli-2", "battistelli-2-radial"}) {
    SCOPED_TRACE(name);
    const Totals ratio = totals_of(name, CostNormalisation::kClutterDensity);
    EXPECT_LT(ratio.true_plot, -5.0);
    EXPECT_LT(ratio.miss_is_cheaper, 0.05);
    const Totals literal = totals_of(name, CostNormalisation::kLiteral);
    EXPECT_GT(literal.true_plot, 0.0);
    EXPECT_GT(literal.miss_is_cheaper, 0.5);
  }
}

TEST(KnownWindowsTest, WithoutClutterCostsAreFinite) {
  ScenarioSpec spec = cut_short(*find_scenario("battistelli-2"), 5);
  spec.world.clutter_per_scan = 0.0;
  for_every_window(spec, 2, [](const KnownTrackWindows& windows, const auto& tuples) {
    for (const Tuple& tuple : tuples) {
      EXPECT_TRUE(std::isfinite(windows.window().problem.views()->tuple_cost(tuple)));
    }
  });
}

double mean_error_km(const std::vector<TargetState>& a, const std::vector<TargetState>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::hypot(a[i].x - b[i].x, a[i].y - b[i].y);
  return sum / static_cast<double>(a.size());
}

/// With every target seen in every scan, resolved, and given its own plots.
TEST(KnownWindowsTest, AdvancingByTheTruthIsTheFilterOnTheTrueTracks) {
  for (const char* name : {"battistelli-1", "battistelli-2", "battistelli-2-radial"}) {
    SCOPED_TRACE(name);
    ScenarioSpec spec = *find_scenario(name);
    spec.world.detection_probability = 1.0 - 1e-9;
    spec.known_targets->resolution_range_km = 0.0;
    const StateHistory ideal = ideal_states(simulate_known(spec, kSeed, 1), spec);
    for (const int window_k : {1, 3}) {
      for_every_window(spec, window_k, [&](KnownTrackWindows& windows, const auto& tuples) {
        const int newest = windows.newest_scan();
        const auto& truth = windows.scene().scans[index(newest - 1)].truth;
        EXPECT_LT(mean_error_km(windows.estimates(tuples), truth), 0.3);
        EXPECT_LT(mean_error_km(windows.estimates(tuples), ideal[index(newest - 1)]), 1e-9);
        if (windows.fixed_scan() == 0) return;
        const auto& fixed = ideal[index(windows.fixed_scan() - 1)];
        EXPECT_LT(mean_error_km(windows.lagged_estimates(), fixed), 1e-9);
      });
    }
  }
}

TEST(KnownWindowsTest, TrueDecisionsAreRight) {
  for (const ScenarioSpec& spec : known_scenarios()) {
    for_every_window(spec, 2, [&](const KnownTrackWindows& windows, const auto& tuples) {
      for (int k = 1; k <= windows.window_scans(); ++k) {
        const int scan = windows.newest_scan() - windows.window_scans() + k;
        const std::vector<int> plots = windows.decisions(tuples, k);
        for (int track = 0; track < windows.tracks(); ++track) {
          EXPECT_TRUE(is_right(windows.scene().scans[index(scan - 1)], plots, track));
        }
      }
    });
  }
}

TEST(KnownWindowsTest, ViewsOutliveTheWindows) {
  AssociationProblem problem;
  std::vector<Tuple> tuples;
  double cost = 0.0;
  {
    KnownTrackWindows windows(*find_scenario("battistelli-2"), kSeed, 1, 2);
    ASSERT_TRUE(windows.next());
    problem = windows.window().problem;
    tuples = true_sequences(windows);
    cost = problem.views()->tuple_cost(tuples[0]);
    windows.advance(tuples);
    ASSERT_TRUE(windows.next());
  }
  EXPECT_EQ(problem.views()->tuple_cost(tuples[0]), cost);
}

TEST(KnownWindowsTest, EstimatesAreTheSameBeforeAndAfterAdvancing) {
  KnownTrackWindows windows(*find_scenario("battistelli-1"), kSeed, 1, 1);
  ASSERT_TRUE(windows.next());
  const std::vector<Tuple> tuples = true_sequences(windows);
  const auto before = windows.estimates(tuples);
  windows.advance(tuples);
  EXPECT_EQ(mean_error_km(windows.estimates(tuples), before), 0.0);
  EXPECT_EQ(mean_error_km(windows.lagged_estimates(), before), 0.0) << "K = 1";
}

TEST(KnownWindowsTest, RefusesWhatIsNoAnswer) {
  const ScenarioSpec& spec = *find_scenario("battistelli-2");
  EXPECT_THROW(KnownTrackWindows(*find_scenario("A"), kSeed, 1, 2), std::invalid_argument);
  EXPECT_THROW(KnownTrackWindows(spec, kSeed, 1, 0), std::invalid_argument);
  KnownTrackWindows windows(spec, kSeed, 1, 1);
  EXPECT_THROW(windows.advance({}), std::invalid_argument) << "no window yet";
  ASSERT_TRUE(windows.next());
  EXPECT_THROW(static_cast<void>(windows.next()), std::logic_error);
  const std::vector<Tuple> right = true_sequences(windows);
  const auto refuses = [&](auto spoil) {
    std::vector<Tuple> tuples = right;
    spoil(tuples);
    EXPECT_THROW(windows.advance(tuples), std::invalid_argument);
  };
  refuses([](auto& tuples) { tuples.pop_back(); });
  refuses([](auto& tuples) { tuples[1].track = 0; });
  refuses([](auto& tuples) { tuples[1].track = 3; });
  refuses([](auto& tuples) { tuples[1].rows.push_back(kNoRow); });
  refuses([](auto& tuples) { tuples[1].rows[0] = 0; });
  refuses([](auto& tuples) { tuples[1].rows[0] = 1000; });
  EXPECT_EQ(windows.fixed_scan(), 0);
  windows.advance(right);
  EXPECT_EQ(windows.fixed_scan(), 1);
}

}  // namespace
}  // namespace mda::testing
