#include "algorithms/heuristic/greedy.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

struct Ranked {
  double gain;  ///< cost minus the coasting cost of the column's track, nats
  double cost;
  int column;
};

bool takes_part(const AssociationProblem& problem, int column) {
  const auto rows = problem.rows_of(column);
  return problem.cost(column) < 0.0 || std::any_of(rows.begin(), rows.end(), [&](int r) {
           return problem.use(r) == RowUse::kExactlyOnce;
         });
}

std::vector<Ranked> ranking(const AssociationProblem& problem) {
  const std::vector<double> coasting = coasting_costs(problem);
  std::vector<Ranked> ranked;
  for (int j = 0; j < problem.columns(); ++j) {
    if (!takes_part(problem, j)) continue;
    double gain = problem.cost(j);
    for (const int r : problem.rows_of(j)) gain -= coasting[index(r)];
    ranked.push_back({gain, problem.cost(j), j});
  }
  std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
    return std::tie(a.gain, a.cost, a.column) < std::tie(b.gain, b.cost, b.column);
  });
  return ranked;
}

class Greedy final : public Associator {
 public:
  [[nodiscard]] Traits traits() const noexcept override { return {.answer = Answer::kSelection}; }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    if (budget.expired()) {
      Solution nothing;
      nothing.stop = Stop::kDeadline;
      return nothing;
    }
    row_used_.assign(index(problem.rows()), 0);
    chosen_.clear();
    for (const Ranked& ranked : ranking(problem)) take_if_free(problem, ranked.column);
    return selection_of(chosen_, problem.columns(), Status::kFeasible);
  }

 private:
  void take_if_free(const AssociationProblem& problem, int column) {
    const auto rows = problem.rows_of(column);
    const bool free =
        std::none_of(rows.begin(), rows.end(), [&](int r) { return row_used_[index(r)] != 0; });
    if (!free) return;
    for (const int r : rows) row_used_[index(r)] = 1;
    chosen_.push_back(column);
  }

  std::vector<char> row_used_;
  std::vector<int> chosen_;
};

}  // namespace

std::unique_ptr<Associator> make_greedy() { return std::make_unique<Greedy>(); }

}  // namespace mda
