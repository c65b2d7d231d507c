#include "algorithms/certified/dual_ascent.h"

#include "algorithms/certified/ascent.h"

namespace mda {
namespace {

constexpr int kPatience = 6;  // nothing comes after it

class DualAscentAssociator final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const WindowPacking& window = packer_.pack(problem);
    AscentResult ascent = ascent_.run(window.packing, budget);
    const bool proven = ascent.closed() && !ascent.expired;
    Pricing pricing;
    fold_into_roots(window.packing, ascent.prices, pricing);
    const double bound = window.bound_nats(pricing.bound);
    const std::vector<int> choice =
        window.completed(problem, origins_of(window.packing, ascent.choice));
    Solution solution = selection_of(
        choice, problem.columns(), proven ? status_of(problem, choice, bound) : Status::kFeasible);
    if (ascent.expired) solution.stop = Stop::kDeadline;
    solution.row_dual = window.row_dual(ascent.prices);
    solution.lower_bound = bound;
    solution.stats.iterations = ascent.rounds;
    return solution;
  }

 private:
  Packer packer_;
  DualAscent ascent_{kPatience};
};

}  // namespace

std::unique_ptr<Associator> make_dual_ascent() { return std::make_unique<DualAscentAssociator>(); }

}  // namespace mda
