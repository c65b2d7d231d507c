#include "algorithms/single_scan/nn.h"

#include <tuple>
#include <vector>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

constexpr int kNothing = -1;

/// A column and its cost; no column costs nothing.
struct Offer {
  double cost = 0.0;
  int column = kNothing;
};

/// A track's wish for a plot.
struct Claim {
  double gain = 0.0;  ///< cost minus that of the track's own alternative, nats
  double cost = 0.0;
  int column = kNothing;

  [[nodiscard]] bool beats(const Claim& other) const {
    return other.column == kNothing ||
           std::tie(gain, cost, column) < std::tie(other.gain, other.cost, other.column);
  }
};

class NearestNeighbour final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override { return {.answer = Answer::kSelection}; }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    if (shape.dimensions > 2) {
      return {false, "takes one scan with fixed tracks, or two without: more than two dimensions"};
    }
    return Associator::can_solve(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    if (budget.expired()) {
      Solution nothing;
      nothing.stop = Stop::kDeadline;
      return nothing;
    }
    find_alternatives(problem);
    find_wishes(problem);
    settle(problem);
    chosen_.clear();
    for (int r = 0; r < problem.rows(); ++r) {
      if (in_pair_[index(r)] == 0 && alone_[index(r)].column != kNothing) {
        chosen_.push_back(alone_[index(r)].column);
      }
    }
    for (const Claim& claim : best_claim_) {
      if (claim.column != kNothing) chosen_.push_back(claim.column);
    }
    return selection_of(chosen_, problem.columns(), Status::kFeasible);
  }

 private:
  /// What every row does when it is in no pair.
  void find_alternatives(const AssociationProblem& problem) {
    alone_.assign(index(problem.rows()), {});
    for (int j = 0; j < problem.columns(); ++j) {
      const auto rows = problem.rows_of(j);
      if (rows.size() > 1) continue;
      Offer& offer = alone_[index(rows.front())];
      const bool must_take_one =
          offer.column == kNothing && problem.use(rows.front()) == RowUse::kExactlyOnce;
      if (must_take_one || problem.cost(j) < offer.cost) offer = {problem.cost(j), j};
    }
  }

  /// The cheapest pair of every track, if it is cheaper than the track's alternative.
  void find_wishes(const AssociationProblem& problem) {
    wish_ = alone_;
    for (int j = 0; j < problem.columns(); ++j) {
      const auto rows = problem.rows_of(j);
      if (rows.size() == 1) continue;
      const bool in_order = problem.dimension(rows.front()) < problem.dimension(rows.back());
      const int track = in_order ? rows.front() : rows.back();
      Offer& wish = wish_[index(track)];
      if (problem.cost(j) < wish.cost) wish = {problem.cost(j), j};
    }
  }

  /// Gives every plot to its best claim.
  void settle(const AssociationProblem& problem) {
    best_claim_.assign(index(problem.rows()), {});
    in_pair_.assign(index(problem.rows()), 0);
    for (int track = 0; track < problem.rows(); ++track) {
      const Offer& wish = wish_[index(track)];
      if (wish.column == alone_[index(track)].column) continue;
      const auto rows = problem.rows_of(wish.column);
      const int plot = rows.front() == track ? rows.back() : rows.front();
      const Claim claim{wish.cost - alone_[index(track)].cost, wish.cost, wish.column};
      if (claim.beats(best_claim_[index(plot)])) best_claim_[index(plot)] = claim;
    }
    for (const Claim& claim : best_claim_) {
      if (claim.column == kNothing) continue;
      for (const int r : problem.rows_of(claim.column)) in_pair_[index(r)] = 1;
    }
  }

  std::vector<Offer> alone_;
  std::vector<Offer> wish_;
  std::vector<Claim> best_claim_;
  std::vector<char> in_pair_;
  std::vector<int> chosen_;
};

}  // namespace

std::unique_ptr<Associator> make_nn() { return std::make_unique<NearestNeighbour>(); }

}  // namespace mda
