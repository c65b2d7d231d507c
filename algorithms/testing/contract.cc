#include "algorithms/testing/contract.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <future>
#include <numeric>

#include "algorithms/testing/marginal_laws.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kRowTolerance = 1e-6;

/// Whether the algorithm takes the problem; if not, it must say why.
bool takes(const Associator& algorithm, const AssociationProblem& problem) {
  const Verdict verdict = algorithm.can_solve(problem.shape());
  EXPECT_TRUE(verdict.ok || !verdict.reason.empty());
  return verdict.ok;
}

/// x has one value in [0, 1] per column, whole if it is a selection, and, with the tuples, breaks
/// no row unless it is marginals.
void expect_point(const AssociationProblem& problem, const Solution& solution) {
  ASSERT_EQ(solution.x.size(), problem.costs().size());
  const bool selection = solution.answer == Answer::kSelection;
  for (const double value : solution.x) {
    EXPECT_TRUE(value >= 0.0 && value <= 1.0) << value;
    if (selection) {
      EXPECT_TRUE(value == 0.0 || value == 1.0) << value;
    }
  }
  EXPECT_TRUE(selection || solution.tuples.empty());
  if (solution.answer != Answer::kMarginals) {
    EXPECT_LE(row_violation(problem, solution), selection ? 0.0 : kRowTolerance);
  }
}

void expect_true_claims(const AssociationProblem& problem, const Solution& solution,
                        const std::optional<double>& best) {
  const double margin = tolerance(problem);
  if (solution.status == Status::kOptimal || solution.status == Status::kFeasible) {
    expect_point(problem, solution);
    if (::testing::Test::HasFatalFailure()) return;
    const double cost = cost_of(problem, solution);
    EXPECT_TRUE(std::isfinite(cost));
    if (solution.answer == Answer::kSelection) {
      // Sequences that are no columns may be better than the best choice of columns.
      const bool columns_only = solution.tuples.empty();
      ASSERT_TRUE(best.has_value() || !columns_only) << "breaks no row, though every choice does";
      if (columns_only) {
        EXPECT_GE(cost, *best - margin);
      }
      if (solution.status == Status::kOptimal) {
        ASSERT_TRUE(best.has_value());
        EXPECT_LE(cost, *best + margin);
      }
    } else if (solution.answer == Answer::kRelaxation && best.has_value()) {
      EXPECT_LE(cost, *best + margin);
    }
  } else {
    EXPECT_EQ(solution.status, Status::kNoAnswer);
    EXPECT_TRUE(solution.x.empty() && solution.tuples.empty());
  }
  if (best.has_value()) {
    EXPECT_LE(solution.lower_bound, *best + margin);
  }
}

/// The multipliers prove the bound of the relaxation: it is the claimed bound, unless an exact
/// choice claims more.
void expect_certificate(const AssociationProblem& problem, const Traits& traits,
                        const Solution& solution, const std::optional<double>& best) {
  const double margin = tolerance(problem);
  ASSERT_EQ(solution.row_dual.size(), index(problem.rows()));
  for (int r = 0; r < problem.rows(); ++r) {
    if (problem.use(r) == RowUse::kAtMostOnce) {
      EXPECT_GE(solution.row_dual[index(r)], 0.0);
    }
  }
  const double certified = certified_bound(problem, solution.row_dual);
  if (best.has_value()) {
    EXPECT_LE(certified, *best + margin);
  }
  EXPECT_LE(certified, solution.lower_bound + margin);
  if (!traits.exact || traits.answer == Answer::kRelaxation) {
    EXPECT_GE(certified, solution.lower_bound - margin);
  }
  const std::vector<double>& point =
      traits.answer == Answer::kRelaxation ? solution.x : solution.relaxation;
  if (!point.empty()) {
    Solution relaxation;
    relaxation.answer = Answer::kRelaxation;
    relaxation.x = point;
    expect_point(problem, relaxation);
    EXPECT_NEAR(cost_of(problem, point), certified, margin) << "not an optimum of the LP";
  }
}

/// What a run without a deadline owes. An answer without proof may be what an iteration had at its
/// limit.
void expect_kept_promises(const AssociationProblem& problem, const Traits& traits,
                          const Solution& solution, const std::optional<double>& best) {
  const bool own_limit = solution.stop == Stop::kIterationLimit && !traits.exact;
  EXPECT_TRUE(own_limit || solution.stop == Stop::kFinished);
  if (solution.status == Status::kNoAnswer) {
    EXPECT_FALSE(best.has_value()) << "no answer, though there is one";
    EXPECT_FALSE(solution.note.empty());
    return;
  }
  if (traits.answer == Answer::kMarginals) {
    expect_distributions(problem, solution, traits.consistent);
  }
  if (traits.exact) {
    EXPECT_EQ(solution.status, Status::kOptimal);
  }
  if (traits.exact && traits.bounds) {
    EXPECT_NEAR(solution.lower_bound, cost_of(problem, solution), tolerance(problem));
  }
  EXPECT_EQ(std::isfinite(solution.lower_bound), traits.bounds);
  if (traits.certifies) {
    expect_certificate(problem, traits, solution, best);
  } else {
    EXPECT_TRUE(solution.row_dual.empty());
  }
}

/// Two answers to two problems of which the second costs factor times the first plus shift.
void expect_related(const AssociationProblem& first, const Solution& a,
                    const AssociationProblem& second, const Solution& b, double factor,
                    double shift) {
  EXPECT_EQ(a.status, b.status);
  ASSERT_EQ(a.x.size(), b.x.size());
  const double margin = factor * tolerance(first) + tolerance(second);
  if (!a.x.empty()) {
    EXPECT_NEAR(factor * cost_of(first, a) + shift, cost_of(second, b), margin);
  }
  ASSERT_EQ(std::isfinite(a.lower_bound), std::isfinite(b.lower_bound));
  if (std::isfinite(a.lower_bound)) {
    EXPECT_NEAR(factor * a.lower_bound + shift, b.lower_bound, margin);
  }
}

void expect_same_tuples(const std::vector<Tuple>& a, const std::vector<Tuple>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].track, b[i].track);
    EXPECT_EQ(a[i].rows, b[i].rows);
  }
}

}  // namespace

void expect_identical(const Solution& a, const Solution& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.stop, b.stop);
  EXPECT_EQ(a.x, b.x);
  expect_same_tuples(a.tuples, b.tuples);
  EXPECT_EQ(a.ranked, b.ranked);
  EXPECT_EQ(a.relaxation, b.relaxation);
  EXPECT_EQ(a.lower_bound, b.lower_bound);
  EXPECT_EQ(a.row_dual, b.row_dual);
  EXPECT_EQ(a.stats.iterations, b.stats.iterations);
  EXPECT_EQ(a.stats.nodes, b.stats.nodes);
  EXPECT_EQ(a.stats.lp_fractional, b.stats.lp_fractional);
  EXPECT_EQ(a.stats.off_column_paths, b.stats.off_column_paths);
  EXPECT_EQ(a.stats.graph_nodes, b.stats.graph_nodes);
  EXPECT_EQ(a.stats.graph_arcs, b.stats.graph_arcs);
}

void expect_lawful_answer(MakeAssociator make, const AssociationProblem& problem,
                          const std::optional<double>& optimum) {
  const auto algorithm = make();
  if (!takes(*algorithm, problem)) return;
  const Solution solution = algorithm->solve(problem, Budget{});
  EXPECT_EQ(solution.answer, algorithm->traits().answer);
  expect_true_claims(problem, solution, optimum);
  if (::testing::Test::HasFatalFailure()) return;
  expect_kept_promises(problem, algorithm->traits(), solution, optimum);
}

void expect_order_does_not_matter(MakeAssociator make, const AssociationProblem& problem,
                                  const AssociationProblem& reordered) {
  const auto algorithm = make();
  if (!takes(*algorithm, problem)) return;
  expect_related(problem, algorithm->solve(problem, Budget{}), reordered,
                 algorithm->solve(reordered, Budget{}), 1.0, 0.0);
}

void expect_marginals_follow(MakeAssociator make, const AssociationProblem& problem,
                             const AssociationProblem& reordered,
                             const std::vector<int>& column_to) {
  const auto algorithm = make();
  if (algorithm->traits().answer != Answer::kMarginals || !takes(*algorithm, problem)) return;
  expect_close_marginals(algorithm->solve(problem, Budget{}), algorithm->solve(reordered, Budget{}),
                         column_to);
}

void expect_scaling(MakeAssociator make, const AssociationProblem& problem, double power_of_2) {
  const auto algorithm = make();
  if (algorithm->traits().answer == Answer::kMarginals || !takes(*algorithm, problem)) return;
  const AssociationProblem other = with_costs(problem, power_of_2);
  expect_related(problem, algorithm->solve(problem, Budget{}), other,
                 algorithm->solve(other, Budget{}), power_of_2, 0.0);
}

void expect_shift(MakeAssociator make, const AssociationProblem& problem, int exactly_once_row,
                  double shift_nats) {
  const auto algorithm = make();
  const Traits traits = algorithm->traits();
  const bool marginals = traits.answer == Answer::kMarginals;
  const bool track = is_track(problem, exactly_once_row);
  if (!(traits.exact || traits.bounds || (marginals && track))) return;
  if (!takes(*algorithm, problem)) return;
  const AssociationProblem other = with_costs(problem, 1.0, shift_nats, exactly_once_row);
  const Solution a = algorithm->solve(problem, Budget{});
  const Solution b = algorithm->solve(other, Budget{});
  if (marginals) {
    std::vector<int> same(index(problem.columns()));
    std::iota(same.begin(), same.end(), 0);
    expect_close_marginals(a, b, same);
  } else if (traits.exact) {
    expect_related(problem, a, other, b, 1.0, shift_nats);
  } else {
    EXPECT_NEAR(a.lower_bound + shift_nats, b.lower_bound, tolerance(problem) + tolerance(other));
  }
}

void expect_no_memory(MakeAssociator make, const AssociationProblem& a,
                      const AssociationProblem& b) {
  const auto algorithm = make();
  if (!takes(*algorithm, a) || !takes(*algorithm, b)) return;
  const Solution first = algorithm->solve(a, Budget{});
  (void)algorithm->solve(b, Budget{});
  expect_identical(first, algorithm->solve(a, Budget{}));
  expect_identical(first, make()->solve(a, Budget{}));
}

void expect_threads_apart(MakeAssociator make, const std::vector<AssociationProblem>& problems) {
  const auto solve_all = [&] {
    const auto algorithm = make();
    std::vector<std::optional<Solution>> solutions;
    for (const AssociationProblem& problem : problems) {
      solutions.emplace_back();
      if (!algorithm->can_solve(problem.shape()).ok) continue;
      solutions.back() = algorithm->solve(problem, Budget{});
    }
    return solutions;
  };
  const auto alone = solve_all();
  std::array<std::future<std::vector<std::optional<Solution>>>, 4> together;
  for (auto& run : together) run = std::async(std::launch::async, solve_all);
  for (auto& run : together) {
    const auto solutions = run.get();
    for (std::size_t i = 0; i < problems.size(); ++i) {
      if (alone[i]) expect_identical(*alone[i], *solutions[i]);
    }
  }
}

void expect_honest_deadline(MakeAssociator make, const AssociationProblem& problem,
                            const std::optional<double>& optimum, int microseconds) {
  const auto algorithm = make();
  if (!takes(*algorithm, problem)) return;
  Budget budget;
  budget.deadline = Clock::now() + std::chrono::microseconds(microseconds);
  const Solution solution = algorithm->solve(problem, budget);
  expect_true_claims(problem, solution, optimum);
  if (solution.stop != Stop::kDeadline && microseconds > 0) {
    expect_kept_promises(problem, algorithm->traits(), solution, optimum);
  } else {
    EXPECT_EQ(solution.stop, Stop::kDeadline);
    EXPECT_NE(solution.status, Status::kOptimal);
  }
}

}  // namespace mda::testing
