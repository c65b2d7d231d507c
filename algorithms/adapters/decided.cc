#include "algorithms/adapters/decided.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kLeastProbability = 1e-300;
constexpr double kLeastDifference = 1e-15;

/// Which rows are tracks, and what is left to a row by its columns.
struct Rows {
  std::vector<char> track;
  std::vector<double> nothing;
  std::vector<int> alone;  ///< the most probable column that uses the row alone, or kNoColumn

  Rows(const AssociationProblem& problem, std::span<const double> x)
      : track(index(problem.rows()), 0),
        nothing(index(problem.rows()), 1.0),
        alone(index(problem.rows()), kNoColumn) {
    int lowest = std::numeric_limits<int>::max();
    for (int r = 0; r < problem.rows(); ++r) lowest = std::min(lowest, problem.dimension(r));
    for (int r = 0; r < problem.rows(); ++r) {
      track[index(r)] = problem.dimension(r) == lowest ? 1 : 0;
    }
    for (int j = 0; j < problem.columns(); ++j) {
      const auto rows = problem.rows_of(j);
      for (const int r : rows) nothing[index(r)] -= x[index(j)];
      if (rows.size() > 1) continue;
      int& best = alone[index(rows.front())];
      if (best == kNoColumn || x[index(j)] > x[index(best)]) best = j;
    }
  }
};

/// Only columns that use a track, whose costs are -ln of how much more probable they are than
/// nothing, if that is possible. `columns`: the problem's, per column of the result.
AssociationProblem track_problem(const AssociationProblem& problem, std::span<const double> x,
                                 const Rows& rows, std::vector<int>& columns) {
  ProblemBuilder builder;
  builder.set_dimensions(problem.shape().dimensions);
  for (int r = 0; r < problem.rows(); ++r) {
    const bool has_other = rows.track[index(r)] == 0 && rows.alone[index(r)] != kNoColumn;
    builder.add_row(problem.dimension(r), has_other ? RowUse::kAtMostOnce : problem.use(r));
  }
  for (int j = 0; j < problem.columns(); ++j) {
    const auto used = problem.rows_of(j);
    const auto track =
        std::find_if(used.begin(), used.end(), [&](int r) { return rows.track[index(r)] != 0; });
    if (track == used.end()) continue;
    const double least = used.size() == 1 ? kLeastDifference : kLeastProbability;
    double cost = -std::log(std::max(x[index(j)], least));
    if (problem.use(*track) == RowUse::kAtMostOnce) {
      cost += std::log(std::max(rows.nothing[index(*track)], kLeastDifference));
    }
    builder.add_column(cost, used);
    columns.push_back(j);
  }
  return builder.build();
}

/// Of rows that are no tracks and that no column of `chosen` uses.
void add_rest(const AssociationProblem& problem, std::span<const double> x, const Rows& rows,
              std::vector<int>& chosen) {
  std::vector<char> used(index(problem.rows()), 0);
  for (const int j : chosen) {
    for (const int r : problem.rows_of(j)) used[index(r)] = 1;
  }
  for (int r = 0; r < problem.rows(); ++r) {
    const int alone = rows.alone[index(r)];
    if (rows.track[index(r)] != 0 || used[index(r)] != 0 || alone == kNoColumn) continue;
    const bool must = problem.use(r) == RowUse::kExactlyOnce;
    if (must || x[index(alone)] > rows.nothing[index(r)]) chosen.push_back(alone);
  }
}

class Decided final : public Associator {
 public:
  Decided(std::unique_ptr<Associator> marginals, std::unique_ptr<Associator> assignment)
      : marginals_(std::move(marginals)), assignment_(std::move(assignment)) {}

  [[nodiscard]] Traits traits() const noexcept override {
    Traits traits = marginals_->traits();
    traits.answer = Answer::kSelection;
    traits.consistent = false;
    return traits;
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    return marginals_->can_solve(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    Solution beliefs = marginals_->solve(problem, budget);
    if (beliefs.status == Status::kNoAnswer) {
      beliefs.answer = Answer::kSelection;
      return beliefs;
    }
    if (beliefs.answer != Answer::kMarginals) {
      throw std::logic_error("only marginals can be decided");
    }
    Solution decision = decide(problem, beliefs.x, *assignment_, budget);
    if (decision.status == Status::kNoAnswer) return decision;
    decision.stop = beliefs.stop;
    decision.stats = beliefs.stats;
    return decision;
  }

 private:
  std::unique_ptr<Associator> marginals_;
  std::unique_ptr<Associator> assignment_;
};

}  // namespace

Solution decide(const AssociationProblem& problem, std::span<const double> marginals,
                Associator& assignment, const Budget& budget) {
  const Rows rows(problem, marginals);
  std::vector<int> columns;
  Solution choice = assignment.solve(track_problem(problem, marginals, rows, columns), budget);
  if (choice.status == Status::kNoAnswer) return choice;
  std::vector<int> chosen;
  for (std::size_t c = 0; c < choice.x.size(); ++c) {
    if (choice.x[c] > 0.5) chosen.push_back(columns[c]);
  }
  add_rest(problem, marginals, rows, chosen);
  return selection_of(chosen, problem.columns(), Status::kFeasible);
}

std::unique_ptr<Associator> make_decided(std::unique_ptr<Associator> marginals,
                                         std::unique_ptr<Associator> assignment) {
  return std::make_unique<Decided>(std::move(marginals), std::move(assignment));
}

}  // namespace mda
