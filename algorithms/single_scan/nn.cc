#include "algorithms/single_scan/nn.h"

#include <tuple>
#include <vector>

#include "algorithms/api/one_scan.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// A track's wish for a plot.
struct Claim {
  double gain = 0.0;  ///< cost minus that of the track's own alternative, nats
  double cost = 0.0;
  int column = kNoColumn;

  [[nodiscard]] bool beats(const Claim& other) const {
    return other.column == kNoColumn ||
           std::tie(gain, cost, column) < std::tie(other.gain, other.cost, other.column);
  }
};

class NearestNeighbour final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override { return {.answer = Answer::kSelection}; }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    const Verdict verdict = takes_one_scan(shape);
    return verdict.ok ? Associator::can_solve(shape) : verdict;
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    if (budget.expired()) {
      Solution nothing;
      nothing.stop = Stop::kDeadline;
      return nothing;
    }
    alone_ = rests_of(problem);
    find_wishes(problem);
    settle(problem);
    chosen_.clear();
    for (int r = 0; r < problem.rows(); ++r) {
      if (in_pair_[index(r)] == 0 && alone_[index(r)].column != kNoColumn) {
        chosen_.push_back(alone_[index(r)].column);
      }
    }
    for (const Claim& claim : best_claim_) {
      if (claim.column != kNoColumn) chosen_.push_back(claim.column);
    }
    return selection_of(chosen_, problem.columns(), Status::kFeasible);
  }

 private:
  /// The cheapest pair of every track, if it is cheaper than the track's alternative.
  void find_wishes(const AssociationProblem& problem) {
    wish_ = alone_;
    for (int j = 0; j < problem.columns(); ++j) {
      const auto rows = problem.rows_of(j);
      if (rows.size() == 1) continue;
      const bool in_order = problem.dimension(rows.front()) < problem.dimension(rows.back());
      const int track = in_order ? rows.front() : rows.back();
      Rest& wish = wish_[index(track)];
      if (problem.cost(j) < wish.cost) wish = {problem.cost(j), j};
    }
  }

  /// Gives every plot to its best claim.
  void settle(const AssociationProblem& problem) {
    best_claim_.assign(index(problem.rows()), {});
    in_pair_.assign(index(problem.rows()), 0);
    for (int track = 0; track < problem.rows(); ++track) {
      const Rest& wish = wish_[index(track)];
      if (wish.column == alone_[index(track)].column) continue;
      const auto rows = problem.rows_of(wish.column);
      const int plot = rows.front() == track ? rows.back() : rows.front();
      const Claim claim{wish.cost - alone_[index(track)].cost, wish.cost, wish.column};
      if (claim.beats(best_claim_[index(plot)])) best_claim_[index(plot)] = claim;
    }
    for (const Claim& claim : best_claim_) {
      if (claim.column == kNoColumn) continue;
      for (const int r : problem.rows_of(claim.column)) in_pair_[index(r)] = 1;
    }
  }

  std::vector<Rest> alone_;
  std::vector<Rest> wish_;
  std::vector<Claim> best_claim_;
  std::vector<char> in_pair_;
  std::vector<int> chosen_;
};

}  // namespace

std::unique_ptr<Associator> make_nn() { return std::make_unique<NearestNeighbour>(); }

}  // namespace mda
