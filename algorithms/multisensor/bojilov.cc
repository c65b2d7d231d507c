#include "algorithms/multisensor/bojilov.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "algorithms/backends/assignment.h"
#include "algorithms/multisensor/thresholds.h"
#include "algorithms/multisensor/tuple_columns.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kNone = -1;

/// Q* / Q in the paper's example.
constexpr double kTreatment = 10.0 / 9.21;

void check(const BojilovOptions& options) {
  const auto refuse = [](const char* why) { throw std::invalid_argument(why); };
  if (!(options.q > 0.0)) refuse("Q must be above 0");
  if (!(options.q3 > 0.0)) refuse("Q3 must be above 0");
  if (options.q_star && !(*options.q_star >= options.q)) refuse("Q* must not be below Q");
  if (options.q3_star && !(*options.q3_star >= std::max(options.q, options.q3))) {
    refuse("Q* of triples must not be below Q and Q3");
  }
}

/// Reports of the first and second sensor in the order of their counts, or kNone.
struct Pair {
  int first = kNone;
  int second = kNone;
  int third = kNone;  ///< what step 3 adds

  [[nodiscard]] bool is_whole() const noexcept { return first != kNone && second != kNone; }
};

class Bojilov final : public Associator {
 public:
  explicit Bojilov(const BojilovOptions& options) : options_(options) { check(options); }

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .needs_sensors = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    if (shape.has_sensors) return {};
    return {false, "needs the distances between the reports of three sensors"};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    Solution solution;
    if (budget.expired()) {
      solution.stop = Stop::kDeadline;
      return solution;
    }
    view_ = &*problem.views()->sensors;
    sensors_ = {0, 1, 2};
    std::ranges::stable_sort(sensors_, std::greater{}, [&](int s) { return view_->reports(s); });
    assign_second();
    const bool expired = budget.expired();
    if (!expired) assign_third();
    solution = answer(problem);
    if (expired) solution.stop = Stop::kDeadline;
    return solution;
  }

 private:
  /// Of reports of the sensors that are a-th and b-th by count.
  [[nodiscard]] double distance(int a, int i, int b, int j) const {
    return view_->between(sensors_[index(a)], i, sensors_[index(b)], j);
  }

  [[nodiscard]] int reports(int place) const { return view_->reports(sensors_[index(place)]); }

  /// A rectangular assignment in which every row takes a column, at least total cost; rows are not
  /// more than columns. Returns the columns.
  template <typename Cost>
  const std::vector<int>& assign(int rows, int columns, Cost cost) {
    costs_.columns = columns;
    costs_.row_begin.assign(1, 0);
    costs_.column.clear();
    costs_.cost.clear();
    costs_.alone.assign(index(rows), kInfinity);
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns; ++j) {
        costs_.column.push_back(j);
        costs_.cost.push_back(cost(i, j));
      }
      costs_.row_begin.push_back(static_cast<int>(costs_.column.size()));
    }
    return assignment_.solve(costs_).column_of_row;
  }

  /// Steps 1 and 2: fills pairs_ with the set L.
  void assign_second() {
    const auto& first_of_second = assign(reports(1), reports(0), [&](int second, int first) {
      const double a = distance(0, first, 1, second);
      return options_.q_star && a > options_.q ? *options_.q_star : a;
    });
    pairs_.assign(index(reports(0)), {});
    for (int i = 0; i < reports(0); ++i) pairs_[index(i)].first = i;
    for (int j = 0; j < reports(1); ++j) {
      const int i = first_of_second[index(j)];
      if (distance(0, i, 1, j) <= options_.q) {
        pairs_[index(i)].second = j;
      } else {
        pairs_.push_back({.second = j});
      }
    }
  }

  /// A of a report of the third sensor with a member of L.
  [[nodiscard]] double cost(const Pair& pair, int third) const {
    double sum = 0.0;
    if (pair.first != kNone) sum += distance(0, pair.first, 2, third);
    if (pair.second != kNone) sum += distance(1, pair.second, 2, third);
    return sum;
  }

  [[nodiscard]] bool is_feasible(const Pair& pair, double cost) const {
    return cost <= (pair.is_whole() ? options_.q3 : options_.q);
  }

  /// The treated cost of what is not feasible in step 3, with a hint that decides ties.
  [[nodiscard]] double price(const Pair& pair) const {
    constexpr double kHint = 1e-9;
    if (!pair.is_whole()) return *options_.q3_star;
    const double narrowness = 2.0 - distance(0, pair.first, 1, pair.second) / options_.q;  // > 0
    const double hint = options_.misfits == Misfits::kToSingles ? kHint : -kHint;
    return *options_.q3_star * (1.0 + hint * narrowness);
  }

  /// Steps 3 and 4.
  void assign_third() {
    const auto& place_of_third =
        assign(reports(2), static_cast<int>(pairs_.size()), [&](int third, int place) {
          const Pair& pair = pairs_[index(place)];
          const double a = cost(pair, third);
          return options_.q3_star && !is_feasible(pair, a) ? price(pair) : a;
        });
    for (int k = 0; k < reports(2); ++k) {
      Pair& pair = pairs_[index(place_of_third[index(k)])];
      if (is_feasible(pair, cost(pair, k))) {
        pair.third = k;
      } else if (options_.infeasible == InfeasibleTriple::kDrop) {
        pair = {};
      }
    }
  }

  [[nodiscard]] Solution answer(const AssociationProblem& problem) const {
    const TupleColumns columns(problem);
    Solution solution;
    solution.status = Status::kFeasible;
    solution.x.assign(index(problem.columns()), 0.0);
    for (const Pair& pair : pairs_) {
      Tuple tuple{.rows = std::vector<int>(SensorView::kSensors, kNoRow)};
      int reports = 0;
      const std::array<int, SensorView::kSensors> report = {pair.first, pair.second, pair.third};
      for (std::size_t place = 0; place < report.size(); ++place) {
        if (report[place] == kNone) continue;
        const auto sensor = index(sensors_[place]);
        tuple.rows[sensor] = view_->row[sensor][index(report[place])];
        ++reports;
      }
      if (reports < 2) continue;
      const int column = columns.find(tuple);
      if (column == kNoColumn) {
        solution.tuples.push_back(std::move(tuple));
      } else {
        solution.x[index(column)] = 1.0;
      }
    }
    solution.stats.off_column_paths = static_cast<int>(solution.tuples.size());
    return solution;
  }

  BojilovOptions options_;
  const SensorView* view_ = nullptr;
  std::array<int, SensorView::kSensors> sensors_{};
  std::vector<Pair> pairs_;
  AssignmentSolver assignment_;
  SparseCosts costs_;
};

}  // namespace

BojilovOptions bojilov_options(double loss) {
  const double q = pair_threshold(loss);
  return {.q = q, .q3 = q, .q_star = kTreatment * q, .q3_star = kTreatment * q};
}

BojilovOptions worst_ties_options(double loss) {
  BojilovOptions options = bojilov_options(loss);
  options.misfits = Misfits::kToPairs;
  return options;
}

BojilovOptions untreated_options(double loss) {
  const double q = pair_threshold(loss);
  return {.q = q, .q3 = q};
}

BojilovOptions calibrated_options(double loss) {
  const double q = pair_threshold(loss);
  const double q3 = triple_threshold(loss);
  return {.q = q,
          .q3 = q3,
          .q_star = kTreatment * q,
          .q3_star = kTreatment * q3,
          .infeasible = InfeasibleTriple::kKeepPair};
}

BojilovOptions a3_options() { return {.q = kInfinity, .q3 = kInfinity}; }

std::unique_ptr<Associator> make_bojilov(const BojilovOptions& options) {
  return std::make_unique<Bojilov>(options);
}

}  // namespace mda
