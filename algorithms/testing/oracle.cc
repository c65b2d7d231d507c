#include "algorithms/testing/oracle.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t mask_of(std::span<const int> rows) {
  std::size_t mask = 0;
  for (const int r : rows) mask |= std::size_t{1} << index(r);
  return mask;
}

std::vector<double> use_of_rows(const AssociationProblem& problem, std::span<const double> x) {
  std::vector<double> use(index(problem.rows()), 0.0);
  for (int j = 0; j < problem.columns(); ++j) {
    for (const int r : problem.rows_of(j)) use[index(r)] += x[index(j)];
  }
  return use;
}

double worst_row(const AssociationProblem& problem, const std::vector<double>& use) {
  double worst = 0.0;
  for (int r = 0; r < problem.rows(); ++r) {
    worst = std::max(worst, use[index(r)] - 1.0);
    if (problem.use(r) == RowUse::kExactlyOnce) worst = std::max(worst, 1.0 - use[index(r)]);
  }
  return worst;
}

bool is_well_formed(const AssociationProblem& problem, const Tuple& tuple) {
  const auto has = [&](int row, int dimension) {
    return row >= 0 && row < problem.rows() && problem.dimension(row) == dimension;
  };
  const Views* views = problem.views();
  if (views == nullptr) return false;
  const bool sensors = views->sensors.has_value();
  if (sensors ? tuple.track != kNoRow : !has(tuple.track, 0)) return false;
  const int scans = sensors ? SensorView::kSensors : views->tree.scans();
  if (tuple.rows.size() != index(scans)) return false;
  for (std::size_t k = 0; k < tuple.rows.size(); ++k) {
    if (tuple.rows[k] != kNoRow && !has(tuple.rows[k], static_cast<int>(k) + 1)) return false;
  }
  return true;
}

std::size_t rows_that_must(const AssociationProblem& problem) {
  std::size_t must = 0;
  for (int r = 0; r < problem.rows(); ++r) {
    if (problem.use(r) == RowUse::kExactlyOnce) must |= std::size_t{1} << index(r);
  }
  return must;
}

/// All choices, from the first column to the last.
class Choices {
 public:
  explicit Choices(const AssociationProblem& problem)
      : problem_(problem), must_(rows_that_must(problem)), weight_of_(index(problem.columns()), 0) {
    visit(0, 0, 1.0L);
  }

  [[nodiscard]] GibbsDistribution distribution() const {
    GibbsDistribution result{.choices = choices_, .probability = {}};
    for (const long double weight : weight_of_) {
      result.probability.push_back(choices_ == 0 ? 0.0 : static_cast<double>(weight / total_));
    }
    return result;
  }

 private:
  void visit(int column, std::size_t used, long double weight) {
    if (column == problem_.columns()) {
      if ((used & must_) != must_) return;
      ++choices_;
      total_ += weight;
      for (const int j : chosen_) weight_of_[index(j)] += weight;
      return;
    }
    visit(column + 1, used, weight);
    const std::size_t mask = mask_of(problem_.rows_of(column));
    if ((used & mask) != 0) return;
    chosen_.push_back(column);
    visit(column + 1, used | mask, weight * std::exp(-1.0L * problem_.cost(column)));
    chosen_.pop_back();
  }

  const AssociationProblem& problem_;
  std::size_t must_;
  std::vector<int> chosen_;
  std::int64_t choices_ = 0;
  long double total_ = 0.0L;
  std::vector<long double> weight_of_;
};

}  // namespace

GibbsDistribution gibbs_distribution(const AssociationProblem& problem) {
  return Choices(problem).distribution();
}

std::optional<double> optimum(const AssociationProblem& problem) {
  assert(problem.rows() <= 20);
  // least[s]: the least cost of a choice that uses exactly the rows of s. A column uses a row, so
  // no choice takes it twice, and the table can be updated in place.
  std::vector<double> least(std::size_t{1} << index(problem.rows()), kInfinity);
  least[0] = 0.0;
  for (int j = 0; j < problem.columns(); ++j) {
    const std::size_t mask = mask_of(problem.rows_of(j));
    for (std::size_t used = 0; used < least.size(); ++used) {
      if ((used & mask) != 0) continue;
      least[used | mask] = std::min(least[used | mask], least[used] + problem.cost(j));
    }
  }
  const std::size_t must = rows_that_must(problem);
  double best = kInfinity;
  for (std::size_t used = 0; used < least.size(); ++used) {
    if ((used & must) == must) best = std::min(best, least[used]);
  }
  return std::isfinite(best) ? std::optional(best) : std::nullopt;
}

double cost_of(const AssociationProblem& problem, std::span<const double> x) {
  double cost = 0.0;
  for (int j = 0; j < problem.columns(); ++j) cost += problem.cost(j) * x[index(j)];
  return cost;
}

double cost_of(const AssociationProblem& problem, const Solution& solution) {
  double cost = cost_of(problem, solution.x);
  for (const Tuple& tuple : solution.tuples) {
    const Views* views = problem.views();
    cost += views != nullptr && views->tuple_cost ? views->tuple_cost(tuple) : kInfinity;
  }
  return cost;
}

double row_violation(const AssociationProblem& problem, std::span<const double> x) {
  return worst_row(problem, use_of_rows(problem, x));
}

double row_violation(const AssociationProblem& problem, const Solution& solution) {
  std::vector<double> use = use_of_rows(problem, solution.x);
  for (const Tuple& tuple : solution.tuples) {
    if (!is_well_formed(problem, tuple)) return kInfinity;
    if (tuple.track != kNoRow) use[index(tuple.track)] += 1.0;
    for (const int row : tuple.rows) {
      if (row != kNoRow) use[index(row)] += 1.0;
    }
  }
  return worst_row(problem, use);
}

double certified_bound(const AssociationProblem& problem, std::span<const double> u) {
  std::vector<double> reduced(problem.costs().begin(), problem.costs().end());
  double bound = 0.0;
  for (int j = 0; j < problem.columns(); ++j) {
    for (const int r : problem.rows_of(j)) reduced[index(j)] += u[index(r)];
    if (reduced[index(j)] < 0.0) bound += reduced[index(j)];
  }
  for (const double multiplier : u) bound -= multiplier;
  return bound;
}

double tolerance(const AssociationProblem& problem) {
  double scale = 1.0;
  for (const double c : problem.costs()) scale += std::abs(c);
  return 1e-7 * scale;
}

}  // namespace mda::testing
