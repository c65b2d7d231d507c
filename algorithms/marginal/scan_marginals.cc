#include "algorithms/marginal/scan_marginals.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "algorithms/api/one_scan.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

Solution no_answer(Stop stop, std::string note) {
  Solution nothing;
  nothing.answer = Answer::kMarginals;
  nothing.stop = stop;
  nothing.note = std::move(note);
  return nothing;
}

void add(std::optional<std::int64_t> number, std::optional<std::int64_t>& to, bool largest) {
  if (!number) return;
  const std::int64_t before = to.value_or(0);
  to = largest ? std::max(before, *number) : before + *number;
}

class ScanMarginals final : public Associator {
 public:
  ScanMarginals(std::unique_ptr<ClusterMethod> method, const ScanMarginalsOptions& options)
      : method_(std::move(method)), options_(options) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kMarginals, .consistent = options_.consistent};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    if (Verdict verdict = takes_one_scan(shape); !verdict.ok) return verdict;
    if (shape.largest_component_columns > options_.most_component_columns) {
      return {false, "takes at most " + std::to_string(options_.most_component_columns) +
                         " columns in one component"};
    }
    return Associator::can_solve(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    if (budget.expired()) return no_answer(Stop::kDeadline, {});
    weights_.read(problem);
    Solution solution;
    solution.status = Status::kFeasible;
    solution.answer = Answer::kMarginals;
    probability_.clear();
    for (const Cluster& cluster : weights_.clusters()) {
      const std::size_t begin = probability_.size();
      probability_.resize(begin + index(cluster.pairs()));
      ClusterAnswer answer =
          method_->solve(cluster, budget, std::span(probability_).subspan(begin));
      if (!answer.known) return no_answer(answer.stop, std::move(answer.note));
      if (answer.stop != Stop::kFinished) solution.stop = answer.stop;
      add(answer.iterations, solution.stats.iterations, true);
      add(answer.events, solution.stats.nodes, false);
    }
    solution.x = weights_.columns(probability_);
    return solution;
  }

 private:
  std::unique_ptr<ClusterMethod> method_;
  ScanMarginalsOptions options_;
  ScanWeights weights_;
  std::vector<double> probability_;
};

}  // namespace

std::unique_ptr<Associator> make_scan_marginals(std::unique_ptr<ClusterMethod> method,
                                                const ScanMarginalsOptions& options) {
  return std::make_unique<ScanMarginals>(std::move(method), options);
}

}  // namespace mda
