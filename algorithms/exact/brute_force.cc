#include "algorithms/exact/brute_force.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/backends/run.h"

namespace mda {
namespace {

constexpr int kMostColumns = 25;

/// One run: a depth-first walk over "take column j, or leave it out".
class Walk {
 public:
  Walk(const AssociationProblem& problem, const Budget& budget)
      : problem_(problem), budget_(budget), row_used_(static_cast<std::size_t>(problem.rows()), 0) {
    for (int r = 0; r < problem.rows(); ++r) {
      if (problem.use(r) == RowUse::kExactlyOnce) ++rows_to_fill_;
    }
  }

  Solution run() {
    if (budget_.expired()) return no_answer(Outcome::kDeadline);
    decide(0, 0.0);
    Solution solution = no_answer(interrupted_ ? Outcome::kDeadline : Outcome::kInfeasible);
    if (found_) {
      solution = selection_of(best_, problem_.columns(),
                              interrupted_ ? Status::kFeasible : Status::kOptimal);
      if (interrupted_) solution.stop = Stop::kDeadline;
      if (!interrupted_) solution.lower_bound = best_cost_;
    }
    solution.stats.nodes = nodes_;
    return solution;
  }

 private:
  void decide(int column, double cost) {
    constexpr std::int64_t kNodesBetweenLooks = 4096;
    if (++nodes_ % kNodesBetweenLooks == 0 && budget_.expired()) interrupted_ = true;
    if (interrupted_) return;
    if (column == problem_.columns()) {
      keep_if_best(cost);
      return;
    }
    const auto rows = problem_.rows_of(column);
    const bool free = std::none_of(rows.begin(), rows.end(), [&](int r) { return used(r); });
    if (free) {
      set_used(rows, true);
      chosen_.push_back(column);
      decide(column + 1, cost + problem_.cost(column));
      chosen_.pop_back();
      set_used(rows, false);
    }
    decide(column + 1, cost);
  }

  void keep_if_best(double cost) {
    if (rows_to_fill_ > 0 || (found_ && cost >= best_cost_)) return;
    found_ = true;
    best_cost_ = cost;
    best_ = chosen_;
  }

  [[nodiscard]] bool used(int row) const { return row_used_[static_cast<std::size_t>(row)] != 0; }

  void set_used(std::span<const int> rows, bool used) {
    for (const int r : rows) {
      row_used_[static_cast<std::size_t>(r)] = used ? 1 : 0;
      if (problem_.use(r) == RowUse::kExactlyOnce) rows_to_fill_ += used ? -1 : 1;
    }
  }

  const AssociationProblem& problem_;
  const Budget& budget_;
  std::vector<char> row_used_;
  std::vector<int> chosen_;
  int rows_to_fill_ = 0;
  bool found_ = false;
  bool interrupted_ = false;
  double best_cost_ = 0.0;
  std::vector<int> best_;
  std::int64_t nodes_ = 0;
};

class BruteForce final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .exact = true, .bounds = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    if (shape.columns <= kMostColumns) return {};
    return {false, "it tries every choice of at most " + std::to_string(kMostColumns) +
                       " columns; this problem has " + std::to_string(shape.columns)};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    return Walk(problem, budget).run();
  }
};

}  // namespace

std::unique_ptr<Associator> make_brute_force() { return std::make_unique<BruteForce>(); }

}  // namespace mda
