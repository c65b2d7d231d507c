#include "algorithms/single_scan/gnn.h"

#include <algorithm>
#include <vector>

#include "algorithms/api/one_scan.h"
#include "algorithms/backends/pair_selection.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Which side of the assignment a row of the problem is on, and its number there.
struct Place {
  bool first;
  int number;
};

class Gnn final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .exact = true, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    return takes_one_scan(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    Solution solution;
    if (budget.expired()) {
      solution.stop = Stop::kDeadline;
      return solution;
    }
    translate(problem);
    const PairSelection& selection = selector_.solve(pairs_);
    if (!selection.feasible) {
      solution.note = "no choice fills the exactly-once rows";
      return solution;
    }
    solution = selection_of(selection.chosen, problem.columns(), Status::kOptimal);
    solution.lower_bound = 0.0;
    for (const int j : selection.chosen) solution.lower_bound += problem.cost(j);
    for (const Place& place : places_) {
      const auto& side = place.first ? selection.first_multiplier : selection.second_multiplier;
      solution.row_dual.push_back(side[index(place.number)]);
    }
    return solution;
  }

 private:
  /// Option j of the pair problem is column j.
  void translate(const AssociationProblem& problem) {
    pairs_ = {};
    places_.clear();
    int lower = problem.rows() > 0 ? problem.dimension(0) : 0;
    for (int r = 1; r < problem.rows(); ++r) lower = std::min(lower, problem.dimension(r));
    for (int r = 0; r < problem.rows(); ++r) {
      const bool first = problem.dimension(r) == lower;
      auto& side = first ? pairs_.first : pairs_.second;
      places_.push_back({first, static_cast<int>(side.size())});
      side.push_back(problem.use(r));
    }
    for (int j = 0; j < problem.columns(); ++j) {
      PairOption option{.cost = problem.cost(j)};
      for (const int r : problem.rows_of(j)) {
        const Place& place = places_[index(r)];
        (place.first ? option.first : option.second) = place.number;
      }
      pairs_.options.push_back(option);
    }
  }

  PairSelector selector_;
  PairProblem pairs_;
  std::vector<Place> places_;
};

}  // namespace

std::unique_ptr<Associator> make_gnn() { return std::make_unique<Gnn>(); }

}  // namespace mda
