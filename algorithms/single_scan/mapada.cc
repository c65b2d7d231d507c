#include "algorithms/single_scan/mapada.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Tracks and plots of the view that are joined by gates.
struct Members {
  std::vector<int> tracks;
  std::vector<int> plots;
};

/// One scan, with the distances the options name.
class Scan {
 public:
  Scan(const AssociationProblem& problem, MapadaDistance distance)
      : problem_(problem), view_(*problem.views()->pairs), distance_(distance) {}

  [[nodiscard]] const PairView& view() const { return view_; }

  [[nodiscard]] bool in_gate(int track, int plot) const {
    return view_.column[view_.at(track, plot)] != kNoColumn;
  }

  [[nodiscard]] double distance(int track, int plot) const {
    switch (distance_) {
      case MapadaDistance::kVelocityLine:
        return view_.line_distance[view_.at(track, plot)];
      case MapadaDistance::kMahalanobis:
        return view_.distance[view_.at(track, plot)];
      case MapadaDistance::kColumnCost:
        break;
    }
    if (!in_gate(track, plot)) return 0.0;
    const int missed = view_.miss_column[index(track)];
    return problem_.cost(view_.column[view_.at(track, plot)]) -
           (missed == kNoColumn ? 0.0 : problem_.cost(missed));
  }

  /// Clusters with a plot.
  [[nodiscard]] std::vector<Members> clusters() const;

 private:
  [[nodiscard]] std::vector<int> cluster_of_track() const;

  const AssociationProblem& problem_;
  const PairView& view_;
  MapadaDistance distance_;
};

/// A name per track: that of the first track of its cluster.
std::vector<int> Scan::cluster_of_track() const {
  std::vector<int> cluster(index(view_.tracks()));
  std::iota(cluster.begin(), cluster.end(), 0);
  for (int j = 0; j < view_.plots(); ++j) {
    int joined = kNoRow;
    for (int t = 0; t < view_.tracks(); ++t) {
      if (!in_gate(t, j)) continue;
      const int other = cluster[index(t)];
      if (joined == kNoRow) joined = other;
      const auto [kept, lost] = std::minmax(joined, other);
      std::replace(cluster.begin(), cluster.end(), int{lost}, int{kept});
      joined = kept;
    }
  }
  return cluster;
}

std::vector<Members> Scan::clusters() const {
  const std::vector<int> name = cluster_of_track();
  std::vector<Members> clusters(name.size());
  for (std::size_t t = 0; t < name.size(); ++t) {
    clusters[index(name[t])].tracks.push_back(static_cast<int>(t));
  }
  for (int j = 0; j < view_.plots(); ++j) {
    int t = 0;
    while (t < view_.tracks() && !in_gate(t, j)) ++t;
    if (t < view_.tracks()) clusters[index(name[index(t)])].plots.push_back(j);
  }
  std::erase_if(clusters, [](const Members& members) { return members.plots.empty(); });
  return clusters;
}

/// Measurement j is plot number j of the members, or a dummy; target t + 1 is track number t.
MapadaCluster in_the_papers_notation(const Scan& scan, const Members& members) {
  MapadaCluster cluster;
  cluster.targets = static_cast<int>(members.tracks.size());
  for (const int plot : members.plots) {
    cluster.add_measurement();
    for (int t = 0; t < cluster.targets; ++t) {
      const int track = members.tracks[index(t)];
      cluster.add_pair(t + 1, scan.distance(track, plot), scan.in_gate(track, plot));
    }
  }
  while (cluster.measurements() <= cluster.targets) {
    cluster.add_measurement();
    for (int t = 1; t <= cluster.targets; ++t) cluster.add_pair(t, 0.0, false);
  }
  return cluster;
}

class Mapada final : public Associator {
 public:
  explicit Mapada(const MapadaOptions& options) : options_(options) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = options_.decision == MapadaDecision::kAssignment ? Answer::kSelection
                                                                       : Answer::kMarginals,
            .needs_pairs = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    if (!shape.has_pairs) return {false, "needs the scan's pairs of tracks and plots"};
    if (!shape.known_tracks) return {false, "takes fixed tracks only: some column is none's"};
    return Associator::can_solve(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    Solution solution;
    solution.answer = traits().answer;
    if (budget.expired()) {
      solution.stop = Stop::kDeadline;
      return solution;
    }
    const Scan scan(problem, options_.distance);
    solution.status = Status::kFeasible;
    solution.x.assign(index(problem.columns()), 0.0);
    for (const int missed : scan.view().miss_column) {
      if (missed != kNoColumn) solution.x[index(missed)] = 1.0;
    }
    std::int64_t iterations = 0;
    for (const Members& members : scan.clusters()) {
      const MapadaCluster cluster = in_the_papers_notation(scan, members);
      const MapadaPoint point = mapada_relaxation(cluster, options_.iteration, budget);
      decide(scan.view(), members, cluster, point.omega, solution.x);
      iterations += point.iterations;
      if (point.stop != Stop::kFinished) solution.stop = point.stop;
    }
    solution.stats.iterations = iterations;
    return solution;
  }

 private:
  void decide(const PairView& view, const Members& members, const MapadaCluster& cluster,
              std::span<const double> omega, std::vector<double>& x) const {
    if (options_.decision == MapadaDecision::kWeighted) {
      for (int t = 0; t < cluster.targets; ++t) weigh(view, members, t, omega, x);
      return;
    }
    const std::vector<int> measurement = options_.decision == MapadaDecision::kAssignment
                                             ? assign_by_omega(cluster, omega)
                                             : largest_omega(cluster, omega);
    const int plots = static_cast<int>(members.plots.size());
    for (int t = 0; t < cluster.targets; ++t) {
      const int j = measurement[index(t)];
      const int track = members.tracks[index(t)];
      const int column =
          j < plots ? view.column[view.at(track, members.plots[index(j)])] : kNoColumn;
      if (column == kNoColumn) continue;
      x[index(column)] = 1.0;
      const int missed = view.miss_column[index(track)];
      if (missed != kNoColumn) x[index(missed)] = 0.0;
    }
  }

  /// beta of one target. Where omega adds up to more than 1, it is divided by its sum.
  static void weigh(const PairView& view, const Members& members, int t,
                    std::span<const double> omega, std::vector<double>& x) {
    const int track = members.tracks[index(t)];
    const auto pairs_of_a_plot = members.tracks.size() + 1;
    double sum = 0.0;
    for (std::size_t j = 0; j < members.plots.size(); ++j) {
      const int column = view.column[view.at(track, members.plots[j])];
      if (column == kNoColumn) continue;
      x[index(column)] = std::clamp(omega[j * pairs_of_a_plot + index(t) + 1], 0.0, 1.0);
      sum += x[index(column)];
    }
    for (const int plot : members.plots) {
      const int column = view.column[view.at(track, plot)];
      if (column != kNoColumn && sum > 1.0) x[index(column)] /= sum;
    }
    const int missed = view.miss_column[index(track)];
    if (missed != kNoColumn) x[index(missed)] = std::max(0.0, 1.0 - sum);
  }

  MapadaOptions options_;
};

}  // namespace

std::unique_ptr<Associator> make_mapada(const MapadaOptions& options) {
  return std::make_unique<Mapada>(options);
}

std::unique_ptr<Associator> make_mapada() { return make_mapada({}); }

}  // namespace mda
