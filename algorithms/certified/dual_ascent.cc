#include "algorithms/certified/dual_ascent.h"

#include "algorithms/certified/ascent.h"

namespace mda {
namespace {

class DualAscentAssociator final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .bounds = true, .certifies = true};
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const WindowPacking& window = packer_.pack(problem);
    AscentResult ascent = ascent_.run(window.packing, budget);
    const bool proven = ascent.closed() && !ascent.expired;
    Solution solution =
        selection_of(window.completed(problem, origins_of(window.packing, ascent.choice)),
                     problem.columns(), proven ? Status::kOptimal : Status::kFeasible);
    if (ascent.expired) solution.stop = Stop::kDeadline;
    Pricing pricing;
    fold_into_roots(window.packing, ascent.prices, pricing);
    solution.row_dual = window.row_dual(ascent.prices);
    solution.lower_bound = window.bound_nats(pricing.bound);
    solution.stats.iterations = ascent.rounds;
    return solution;
  }

 private:
  Packer packer_;
  DualAscent ascent_;
};

}  // namespace

std::unique_ptr<Associator> make_dual_ascent() { return std::make_unique<DualAscentAssociator>(); }

}  // namespace mda
