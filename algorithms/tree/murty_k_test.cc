#include "algorithms/tree/murty_k.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/tiny_problems.h"

namespace mda::testing {
namespace {

std::unique_ptr<Associator> exact() { return find_algorithm("exact")->make(); }

Solution ranked(const AssociationProblem& problem, int choices) {
  return make_murty_k({choices}, exact())->solve(problem, Budget{});
}

double cost_of(const AssociationProblem& problem, const Choice& choice) {
  double cost = 0.0;
  for (const int j : choice) cost += problem.cost(j);
  return cost;
}

double violation(const AssociationProblem& problem, const Choice& choice) {
  return row_violation(problem, selection_of(choice, problem.columns(), Status::kFeasible).x);
}

/// The costs of all choices that break no row, ascending, by trying every set of columns that uses
/// no row twice.
class Enumeration {
 public:
  explicit Enumeration(const AssociationProblem& problem)
      : problem_(problem), used_(static_cast<std::size_t>(problem.rows()), 0) {
    decide(0);
    std::sort(costs_.begin(), costs_.end());
  }

  [[nodiscard]] const std::vector<double>& costs() const { return costs_; }

 private:
  void decide(int column) {
    if (column == problem_.columns()) {
      if (violation(problem_, choice_) == 0.0) costs_.push_back(cost_of(problem_, choice_));
      return;
    }
    decide(column + 1);
    const auto rows = problem_.rows_of(column);
    const auto used = [&](int r) -> char& { return used_[static_cast<std::size_t>(r)]; };
    if (std::any_of(rows.begin(), rows.end(), [&](int r) { return used(r) != 0; })) return;
    for (const int r : rows) used(r) = 1;
    choice_.push_back(column);
    decide(column + 1);
    choice_.pop_back();
    for (const int r : rows) used(r) = 0;
  }

  const AssociationProblem& problem_;
  std::vector<char> used_;
  Choice choice_;
  std::vector<double> costs_;
};

/// As many choices as asked for, or all; lawful, different, in order, and none better left out.
void expect_k_best(const AssociationProblem& problem, const Solution& solution,
                   const std::vector<double>& all, int choices) {
  ASSERT_EQ(solution.ranked.size(), std::min(all.size(), static_cast<std::size_t>(choices)));
  const std::set<Choice> different(solution.ranked.begin(), solution.ranked.end());
  EXPECT_EQ(different.size(), solution.ranked.size());
  std::pair<double, Choice> last;
  for (std::size_t i = 0; i < solution.ranked.size(); ++i) {
    const Choice& choice = solution.ranked[i];
    EXPECT_TRUE(std::is_sorted(choice.begin(), choice.end()));
    EXPECT_EQ(violation(problem, choice), 0.0);
    EXPECT_NEAR(cost_of(problem, choice), all[i], tolerance(problem));
    std::pair<double, Choice> next{cost_of(problem, choice), choice};
    if (i > 0) {
      EXPECT_LT(last, next) << "of equal cost, the lexicographically first comes first";
    }
    last = std::move(next);
  }
  if (solution.ranked.empty()) return;
  EXPECT_EQ(solution.x,
            selection_of(solution.ranked.front(), problem.columns(), Status::kOptimal).x);
}

TEST(MurtyKTest, EqualsEnumeration) {
  int with_ties = 0;
  int must_be_filled = 0;
  int costs_something = 0;
  int several_components = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_problem(random_shape(seed, 18), seed);
    const std::vector<double> all = Enumeration(problem).costs();
    const int choices = 1 + static_cast<int>(seed % 12);
    const Solution solution = ranked(problem, choices);
    ASSERT_EQ(solution.status, all.empty() ? Status::kNoAnswer : Status::kOptimal);
    expect_k_best(problem, solution, all, choices);
    if (solution.ranked.size() < 2) continue;
    with_ties += std::adjacent_find(all.begin(), all.end()) != all.end() ? 1 : 0;
    must_be_filled += problem.shape().has_exactly_once_rows ? 1 : 0;
    costs_something += all.back() > 0.0 ? 1 : 0;
    several_components += problem.shape().components > 1 ? 1 : 0;
  }
  EXPECT_GE(with_ties, 50);
  EXPECT_GE(must_be_filled, 50);
  EXPECT_GE(costs_something, 50);
  EXPECT_GE(several_components, 50);
}

TEST(MurtyKTest, FindsEveryChoice) {
  int choices_found = 0;
  for (std::uint64_t seed = 401; seed <= 480; ++seed) {
    SCOPED_TRACE(seed);
    const AssociationProblem problem = random_problem(random_shape(seed, 15), seed);
    const std::vector<double> all = Enumeration(problem).costs();
    if (all.size() > 300) continue;
    const int more_than_all = static_cast<int>(all.size()) + 1;
    expect_k_best(problem, ranked(problem, more_than_all), all, more_than_all);
    choices_found += static_cast<int>(all.size());
  }
  EXPECT_GE(choices_found, 1000);
}

TEST(MurtyKTest, WithoutColumnsThereIsOneChoice) {
  const Solution solution = ranked(tiny_problem("no columns").problem, 5);
  EXPECT_EQ(solution.status, Status::kOptimal);
  EXPECT_EQ(solution.ranked, std::vector<Choice>{{}});
}

/// An exact algorithm that is at its deadline from one call on.
class OutOfTime final : public Associator {
 public:
  explicit OutOfTime(int calls) : calls_(calls) {}
  [[nodiscard]] Traits traits() const noexcept override { return inner_->traits(); }
  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    if (calls_-- > 0) return inner_->solve(problem, budget);
    Solution nothing;
    nothing.stop = Stop::kDeadline;
    return nothing;
  }

 private:
  std::unique_ptr<Associator> inner_ = exact();
  int calls_;
};

TEST(MurtyKTest, RanksWhatIsProvenAtTheDeadline) {
  const AssociationProblem problem =
      side_by_side({odd_cycle(5, RowUse::kAtMostOnce, 1), odd_cycle(5, RowUse::kExactlyOnce, 2),
                    odd_cycle(7, RowUse::kAtMostOnce, 3)});
  const std::vector<double> all = Enumeration(problem).costs();
  constexpr int kChoices = 20;
  std::size_t most = 0;
  std::size_t least = kChoices;
  for (int calls = 0; calls <= 60; ++calls) {
    SCOPED_TRACE(calls);
    const Solution solution =
        make_murty_k({kChoices}, std::make_unique<OutOfTime>(calls))->solve(problem, Budget{});
    most = std::max(most, solution.ranked.size());
    least = std::min(least, solution.ranked.size());
    if (solution.stop == Stop::kFinished) {
      EXPECT_EQ(solution.status, Status::kOptimal);
      EXPECT_EQ(solution.ranked.size(), kChoices);
    } else {
      EXPECT_EQ(solution.status, calls == 0 ? Status::kNoAnswer : Status::kFeasible);
    }
    expect_k_best(problem, solution, all, static_cast<int>(solution.ranked.size()));
  }
  EXPECT_EQ(least, 0U);
  EXPECT_EQ(most, static_cast<std::size_t>(kChoices));
}

TEST(MurtyKTest, RefusesWhatMakesNoSense) {
  EXPECT_THROW((void)make_murty_k({0}, exact()), std::invalid_argument);
  EXPECT_THROW((void)make_murty_k({}, nullptr), std::invalid_argument);
}

}  // namespace
}  // namespace mda::testing
