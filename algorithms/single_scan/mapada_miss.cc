#include "algorithms/single_scan/mapada_miss.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/api/one_scan.h"
#include "algorithms/single_scan/mapada_relaxation.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// A pair that is cheaper than its rows alone.
struct Pair {
  int target;  ///< rows of the problem
  int plot;
  int column;
  double cost;  ///< in units of the scan, negative
};

/// The pairs of every component, in order of their costs.
class Pairs {
 public:
  Pairs(const AssociationProblem& problem, const std::vector<Rest>& rests) {
    for (int j = 0; j < problem.columns(); ++j) {
      const auto rows = problem.rows_of(j);
      if (rows.size() == 1) continue;
      const bool ordered = problem.dimension(rows.front()) < problem.dimension(rows.back());
      const int target = ordered ? rows.front() : rows.back();
      const int plot = ordered ? rows.back() : rows.front();
      const double cost = problem.cost(j) - (rests[index(target)].cost + rests[index(plot)].cost);
      if (cost < 0.0) all_.push_back({target, plot, j, cost});
    }
    std::stable_sort(all_.begin(), all_.end(),
                     [](const Pair& a, const Pair& b) { return a.cost < b.cost; });
    express_in_units();
    sort_into_components(problem);
  }

  [[nodiscard]] const std::vector<std::vector<Pair>>& components() const { return components_; }

 private:
  /// The unit is a power of 2, so that nothing is rounded.
  void express_in_units() {
    if (all_.empty()) return;
    int exponent = 0;
    (void)std::frexp(all_.front().cost, &exponent);
    for (Pair& pair : all_) pair.cost = std::ldexp(pair.cost, -exponent);
  }

  void sort_into_components(const AssociationProblem& problem) {
    std::vector<int> place(index(problem.shape().components), -1);
    for (const Pair& pair : all_) {
      int& number = place[index(problem.component_of_column()[index(pair.column)])];
      if (number < 0) {
        number = static_cast<int>(components_.size());
        components_.emplace_back();
      }
      components_[index(number)].push_back(pair);
    }
  }

  std::vector<Pair> all_;
  std::vector<std::vector<Pair>> components_;
};

/// Rows of one side, numbered in the order in which they first come.
class Numbers {
 public:
  explicit Numbers(int rows) : number_(index(rows), -1) {}

  int of(int row) {
    int& number = number_[index(row)];
    if (number < 0) number = count_++;
    return number;
  }
  [[nodiscard]] int count() const { return count_; }

 private:
  std::vector<int> number_;
  int count_ = 0;
};

/// The pairs of every plot; of several with one target the first, which is the cheapest.
std::vector<std::vector<Pair>> by_plot(const std::vector<Pair>& component, int rows) {
  Numbers numbers(rows);
  for (const Pair& pair : component) numbers.of(pair.plot);
  std::vector<std::vector<Pair>> plots(index(numbers.count()));
  for (const Pair& pair : component) {
    auto& pairs = plots[index(numbers.of(pair.plot))];
    const bool known = std::any_of(pairs.begin(), pairs.end(),
                                   [&](const Pair& other) { return other.target == pair.target; });
    if (!known) pairs.push_back(pair);
  }
  return plots;
}

class MapadaMiss final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override { return {.answer = Answer::kSelection}; }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    const Verdict verdict = takes_one_scan(shape);
    return verdict.ok ? Associator::can_solve(shape) : verdict;
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    Solution solution;
    if (budget.expired()) {
      solution.stop = Stop::kDeadline;
      return solution;
    }
    const std::vector<Rest> rests = rests_of(problem);
    chosen_.clear();
    std::int64_t iterations = 0;
    Stop stop = Stop::kFinished;
    const Pairs pairs(problem, rests);
    for (const std::vector<Pair>& component : pairs.components()) {
      const MapadaPoint point = associate(component, problem.rows(), budget);
      iterations += point.iterations;
      if (point.stop != Stop::kFinished) stop = point.stop;
    }
    std::vector<char> paired(index(problem.rows()), 0);
    for (const int j : chosen_) {
      for (const int r : problem.rows_of(j)) paired[index(r)] = 1;
    }
    for (int r = 0; r < problem.rows(); ++r) {
      const int alone = rests[index(r)].column;
      if (paired[index(r)] == 0 && alone != kNoColumn) chosen_.push_back(alone);
    }
    solution = selection_of(chosen_, problem.columns(), Status::kFeasible);
    solution.stop = stop;
    solution.stats.iterations = iterations;
    return solution;
  }

 private:
  /// Relaxes one component and appends its pairs to the choice. Measurements are the plots, then
  /// the private ones.
  MapadaPoint associate(const std::vector<Pair>& component, int rows, const Budget& budget) {
    Numbers targets(rows);
    const std::vector<std::vector<Pair>> plots = by_plot(component, rows);
    MapadaCluster cluster;
    for (const auto& pairs : plots) {
      cluster.add_measurement();
      for (const Pair& pair : pairs) cluster.add_pair(targets.of(pair.target) + 1, pair.cost, true);
    }
    cluster.targets = targets.count();
    for (int t = 1; t <= cluster.targets; ++t) {
      cluster.add_measurement();
      cluster.add_pair(t, 0.0, true);
    }
    MapadaPoint point = mapada_relaxation(cluster, options_for(cluster), budget);
    const std::vector<int> measurement = assign_by_omega(cluster, point.omega);
    for (std::size_t j = 0; j < plots.size(); ++j) {
      for (const Pair& pair : plots[j]) {
        if (index(measurement[index(targets.of(pair.target))]) == j) {
          chosen_.push_back(pair.column);
        }
      }
    }
    return point;
  }

  static MapadaIteration options_for(const MapadaCluster& cluster) {
    constexpr int kMostIterations = 20000;
    return {.alpha = std::sqrt(2.0 * (cluster.measurements() + cluster.targets + 1)),
            .tolerance = kMapadaMissTolerance,
            .iterations = kMostIterations,
            .clip = false};
  }

  std::vector<int> chosen_;
};

}  // namespace

std::unique_ptr<Associator> make_mapada_miss() { return std::make_unique<MapadaMiss>(); }

}  // namespace mda
