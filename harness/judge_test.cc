#include "harness/judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "algorithms/testing/random_problems.h"

namespace mda::testing {
namespace {

using Answering = std::function<Solution(const AssociationProblem&, const Budget&)>;

/// An algorithm that does as it is told.
class Puppet final : public Associator {
 public:
  Puppet(Traits traits, Answering answering) : traits_(traits), answering_(std::move(answering)) {}
  [[nodiscard]] Traits traits() const noexcept override { return traits_; }
  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    if (shape.columns == 999) return {false, "not today"};
    if (shape.columns == 998) throw std::logic_error("cannot even say");
    return {};
  }
  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    return answering_(problem, budget);
  }

 private:
  Traits traits_;
  Answering answering_;
};

constexpr CatalogEntry entry_named(std::string_view name, bool reference = false) {
  CatalogEntry entry{};
  entry.name = name;
  entry.reference = reference;
  return entry;
}

constexpr CatalogEntry kHonest = entry_named("honest", true);
constexpr CatalogEntry kPlanted = entry_named("planted");
constexpr CatalogEntry kOther = entry_named("other");
constexpr Traits kExact = {.exact = true};

Player player(const CatalogEntry& entry, Answering answering, Traits traits = {}) {
  return {&entry, true, std::make_unique<Puppet>(traits, std::move(answering))};
}

/// The best is column 2 alone (-5), then columns 0 and 1 (-4), then one of them (-2). `more` lone
/// columns of rows of their own and positive cost follow.
AssociationProblem two_or_one(RowUse use = RowUse::kAtMostOnce, int more = 0) {
  ProblemBuilder builder;
  for (const int dimension : {1, 2}) builder.add_row(dimension, use);
  builder.add_column(-2.0, std::vector<int>{0});
  builder.add_column(-2.0, std::vector<int>{1});
  builder.add_column(-5.0, std::vector<int>{0, 1});
  for (int i = 0; i < more; ++i) {
    builder.add_column(1.0, std::vector<int>{builder.add_row(1, RowUse::kAtMostOnce)});
  }
  return builder.build();
}

Answering choosing(const std::vector<int>& columns, Status status) {
  return [=](const AssociationProblem& problem, const Budget&) {
    return selection_of(columns, problem.columns(), status);
  };
}

const Answering kTruth = choosing({2}, Status::kOptimal);

Verdicts verdicts_of(const AssociationProblem& problem, const std::vector<Player>& players,
                     double time_limit_s = 10.0) {
  return judge(problem, solve_all(problem, players, {.time_limit_s = time_limit_s}));
}

struct Plant {
  const char* name;
  Answering answering;
  Status status;
  Stop stop;
  bool refuted;
  const char* note;
};

std::vector<Plant> plants() {
  const auto changed = [](const std::vector<int>& columns, Status status,
                          const std::function<void(Solution&)>& change) -> Answering {
    return [=](const AssociationProblem& p, const Budget&) {
      Solution solution = selection_of(columns, p.columns(), status);
      change(solution);
      return solution;
    };
  };
  const double nan = std::nan("");
  return {
      {"throws",
       [](const auto&, const auto&) -> Solution { throw std::runtime_error("my own bug"); },
       Status::kFailed, Stop::kError, false, "my own bug"},
      {"throws an int", [](const auto&, const auto&) -> Solution { throw 7; }, Status::kFailed,
       Stop::kError, false, "not an exception"},
      {"answers NaN", changed({2}, Status::kFeasible, [=](Solution& s) { s.x[0] = nan; }),
       Status::kFailed, Stop::kFinished, true, "x is not"},
      {"answers nothing but says so not", changed({}, Status::kOptimal, [](auto& s) { s.x = {}; }),
       Status::kFailed, Stop::kFinished, true, "x is not"},
      {"breaks a row", choosing({0, 2}, Status::kFeasible), Status::kFailed, Stop::kFinished, true,
       "a row is broken by 1"},
      {"halves a column", changed({2}, Status::kFeasible, [](Solution& s) { s.x[2] = 0.5; }),
       Status::kFailed, Stop::kFinished, true, "neither used nor unused"},
      {"claims optimal wrongly", choosing({0, 1}, Status::kOptimal), Status::kFailed,
       Stop::kFinished, true, "claimed optimal at -4, but -5 is known"},
      {"claims too good a bound",
       changed({2}, Status::kFeasible, [](Solution& s) { s.lower_bound = -4.0; }), Status::kFailed,
       Stop::kFinished, true, "claimed the bound -4, but -5 is known"},
      {"claims no number as bound",
       changed({2}, Status::kFeasible, [=](Solution& s) { s.lower_bound = nan; }), Status::kFailed,
       Stop::kFinished, true, "not a number"},
      {"has no answer",
       changed({}, Status::kNoAnswer, [](Solution& s) { s.stop = Stop::kIterationLimit; }),
       Status::kNoAnswer, Stop::kIterationLimit, false, ""},
      {"is worse, and says so", choosing({0}, Status::kFeasible), Status::kFeasible,
       Stop::kFinished, false, ""},
      {"is right", kTruth, Status::kOptimal, Stop::kFinished, false, ""},
  };
}

TEST(JudgeTest, EveryPlantCostsOneAttemptAndNobodyElseAnything) {
  const AssociationProblem problem = two_or_one();
  for (const Plant& plant : plants()) {
    SCOPED_TRACE(plant.name);
    std::vector<Player> players;
    players.push_back(player(kOther, choosing({0, 1}, Status::kFeasible)));
    players.push_back(player(kPlanted, plant.answering));
    players.push_back(player(kHonest, kTruth, kExact));
    const Verdicts verdicts = verdicts_of(problem, players);
    ASSERT_EQ(verdicts.attempts.size(), 3U);

    const Attempt& planted = verdicts.attempts[1];
    EXPECT_EQ(planted.player->entry->name, "planted");
    EXPECT_EQ(planted.solution.status, plant.status);
    EXPECT_EQ(planted.solution.stop, plant.stop);
    EXPECT_EQ(planted.refuted, plant.refuted);
    EXPECT_FALSE(planted.skipped);
    EXPECT_NE(planted.note.find(plant.note), std::string::npos) << planted.note;

    EXPECT_EQ(verdicts.attempts[0].solution.status, Status::kFeasible);
    EXPECT_EQ(verdicts.attempts[0].examined.cost, -4.0);
    EXPECT_EQ(verdicts.attempts[2].solution.status, Status::kOptimal);
    EXPECT_EQ(verdicts.attempts[2].examined.cost, -5.0);
    EXPECT_EQ(verdicts.attempts[0].note + verdicts.attempts[2].note, "");
    EXPECT_EQ(verdicts.reference_cost, -5.0);
    EXPECT_TRUE(verdicts.reference_proven);
  }
}

TEST(JudgeTest, WhoDeclinesIsSkippedWithTheReason) {
  std::vector<Player> players;
  players.push_back(player(kHonest, kTruth));
  const Verdicts verdicts = verdicts_of(two_or_one(RowUse::kAtMostOnce, 996), players);
  EXPECT_TRUE(verdicts.attempts[0].skipped);
  EXPECT_FALSE(verdicts.attempts[0].refuted);
  EXPECT_EQ(verdicts.attempts[0].note, "not today");
}

TEST(JudgeTest, WhoThrowsWhenAskedHasFailed) {
  std::vector<Player> players;
  players.push_back(player(kHonest, kTruth));
  const Verdicts verdicts = verdicts_of(two_or_one(RowUse::kAtMostOnce, 995), players);
  EXPECT_FALSE(verdicts.attempts[0].skipped);
  EXPECT_EQ(verdicts.attempts[0].solution.status, Status::kFailed);
  EXPECT_EQ(verdicts.attempts[0].note, "cannot even say");
}

TEST(JudgeTest, WhoSleepsPastTheDeadlineCostsNobodyElseTime) {
  std::vector<Player> players;
  players.push_back(player(kPlanted, [](const AssociationProblem& p, const Budget& budget) {
    while (!budget.expired()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    Solution late = selection_of({0}, p.columns(), Status::kFeasible);
    late.stop = Stop::kDeadline;
    return late;
  }));
  players.push_back(player(kHonest, [](const AssociationProblem& p, const Budget& budget) {
    EXPECT_GT(budget.seconds_left(), 0.0) << "a deadline of its own";
    return kTruth(p, budget);
  }));
  const Verdicts verdicts = verdicts_of(two_or_one(), players, 0.03);
  EXPECT_EQ(verdicts.attempts[0].solution.status, Status::kFeasible);
  EXPECT_EQ(verdicts.attempts[0].solution.stop, Stop::kDeadline);
  EXPECT_GE(verdicts.attempts[0].wall_ms, 49.0);
}

TEST(JudgeTest, TheReferenceIsTheYardstickEvenWhereItIsWorse) {
  std::vector<Player> players;
  players.push_back(player(kPlanted, choosing({2}, Status::kFeasible)));
  players.push_back(player(kHonest, choosing({0, 1}, Status::kFeasible)));
  const Verdicts verdicts = verdicts_of(two_or_one(), players);
  EXPECT_EQ(verdicts.reference_cost, -4.0);
  EXPECT_FALSE(verdicts.reference_proven);
}

TEST(JudgeTest, WithoutTheReferenceTheBestChoiceIsTheYardstick) {
  std::vector<Player> players;
  players.push_back(player(kPlanted, choosing({0, 1}, Status::kFeasible)));
  players.push_back(player(kHonest, choosing({0, 2}, Status::kOptimal)));
  EXPECT_EQ(verdicts_of(two_or_one(), players).reference_cost, -4.0);
  players.erase(players.begin());
  EXPECT_EQ(verdicts_of(two_or_one(), players).reference_cost, 0.0) << "doing nothing";
  EXPECT_FALSE(verdicts_of(two_or_one(RowUse::kExactlyOnce), players).reference_cost);
}

TEST(JudgeTest, ExactSpreadComparesOnlyFinishedExactPlayers) {
  const AssociationProblem problem = two_or_one();
  // Below the tolerance of a refutation, so that both claims stand.
  ProblemBuilder builder;
  builder.add_row(1, RowUse::kAtMostOnce);
  builder.add_column(-5.0, std::vector<int>{0});
  builder.add_column(-5.000004, std::vector<int>{0});
  const AssociationProblem close = builder.build();
  const auto spread = [](const AssociationProblem& p, Answering a, Answering b,
                         Traits traits_of_b) {
    std::vector<Player> players;
    players.push_back(player(kHonest, std::move(a), kExact));
    players.push_back(player(kPlanted, std::move(b), traits_of_b));
    return verdicts_of(p, players).exact_spread;
  };
  const Answering first = choosing({0}, Status::kOptimal);
  const Answering second = choosing({1}, Status::kOptimal);
  ASSERT_TRUE(spread(close, first, second, kExact));
  EXPECT_NEAR(*spread(close, first, second, kExact), 4e-6, 1e-12);
  EXPECT_EQ(spread(close, second, second, kExact), 0.0);
  EXPECT_FALSE(spread(close, first, second, {})) << "not exact";
  EXPECT_FALSE(spread(close, first, choosing({1}, Status::kFeasible), kExact)) << "not finished";
  EXPECT_FALSE(spread(problem, kTruth, choosing({0, 1}, Status::kOptimal), kExact)) << "refuted";
}

TEST(JudgeTest, TheDriverAdvancesTheWindowAndHasStandIns) {
  const AssociationProblem problem = two_or_one();
  const auto advanced_by = [&](Answering driver, bool expect_fallback) {
    std::vector<Player> players;
    players.push_back(player(kOther, choosing({0}, Status::kFeasible)));
    players.push_back(player(kPlanted, std::move(driver)));
    players.push_back(player(kHonest, choosing({0, 1}, Status::kFeasible)));
    const Decision decision = advancing_choice(problem, verdicts_of(problem, players), "planted");
    EXPECT_EQ(decision.fell_back, expect_fallback);
    return decision.x;
  };
  using X = std::vector<double>;
  EXPECT_EQ(advanced_by(choosing({2}, Status::kOptimal), false), (X{0, 0, 1}));
  EXPECT_EQ(advanced_by(choosing({1}, Status::kFeasible), false), (X{0, 1, 0})) << "however bad";
  EXPECT_EQ(advanced_by(choosing({0, 2}, Status::kFeasible), true), (X{1, 1, 0}));
  EXPECT_EQ(advanced_by(choosing({0}, Status::kOptimal), true), (X{1, 1, 0}));
  EXPECT_EQ(advanced_by([](const auto&, const auto&) { return Solution(); }, true), (X{1, 1, 0}));
  EXPECT_EQ(advancing_choice(problem, {}, "planted").x, (X{0, 0, 0}));
  EXPECT_TRUE(advancing_choice(problem, {}, "planted").fell_back);
}

TEST(JudgeTest, AShortSolveIsRepeatedAndTheFastestCounts) {
  const AssociationProblem problem = two_or_one();
  int turns = 0;
  std::vector<Player> players;
  players.push_back(player(kPlanted, [&turns](const auto& asked, const auto& budget) {
    ++turns;
    return kTruth(asked, budget);
  }));
  const auto attempts = solve_all(problem, players, {.repeats = 4});
  EXPECT_EQ(turns, 4);
  EXPECT_EQ(attempts[0].solution.status, Status::kOptimal);
  EXPECT_LE(4 * attempts[0].cpu_ms, attempts[0].spent_cpu_ms * (1 + 1e-9));
}

TEST(JudgeTest, AnAnswerThatIsNotTheSameEveryTimeFails) {
  int turns = 0;
  std::vector<Player> players;
  players.push_back(player(kPlanted, [&turns](const auto& asked, const auto& budget) {
    return choosing({++turns == 3 ? 0 : 2}, Status::kFeasible)(asked, budget);
  }));
  const auto attempts = solve_all(two_or_one(), players, {.repeats = 9});
  EXPECT_EQ(turns, 3);
  EXPECT_EQ(attempts[0].solution.status, Status::kFailed);
  EXPECT_EQ(attempts[0].note, "asked again, it gave another answer");
  turns = 0;
  EXPECT_EQ(solve_all(two_or_one(), players, {}).front().solution.status, Status::kFeasible);
  EXPECT_EQ(turns, 1);
}

TEST(JudgeTest, AFinishedAnswerStandsWhenALaterTurnRunsOutOfTime) {
  int turns = 0;
  std::vector<Player> players;
  players.push_back(player(kPlanted, [&turns](const auto& asked, const auto& budget) {
    if (++turns == 1) return kTruth(asked, budget);
    Solution cut_short = choosing({0}, Status::kFeasible)(asked, budget);
    cut_short.stop = Stop::kDeadline;
    return cut_short;
  }));
  const auto attempts = solve_all(two_or_one(), players, {.repeats = 9});
  EXPECT_EQ(turns, 2);
  EXPECT_EQ(attempts[0].solution.status, Status::kOptimal);
}

TEST(JudgeTest, ThePlayingOrderDependsOnTheProblemAlone) {
  std::vector<std::size_t> order;
  std::vector<Player> players;
  for (std::size_t i = 0; i < 5; ++i) {
    players.push_back(player(kPlanted, [&order, i](const auto&, const auto&) {
      order.push_back(i);
      return Solution();
    }));
  }
  const auto order_of = [&](const AssociationProblem& problem, std::uint64_t seed) {
    order.clear();
    EXPECT_EQ(solve_all(problem, players, {.seed = seed}).size(), players.size());
    return order;
  };
  std::set<std::vector<std::size_t>> orders;
  std::set<std::size_t> first;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const AssociationProblem problem = random_problem(random_shape(seed, 24), seed);
    const std::vector<std::size_t> seen = order_of(problem, 1);
    EXPECT_EQ(std::set<std::size_t>(seen.begin(), seen.end()).size(), 5U) << "everyone, once";
    EXPECT_EQ(order_of(problem, 1), seen);
    EXPECT_EQ(order_of(problem, 77), seen) << "whatever the solvers' seed";
    orders.insert(seen);
    first.insert(seen[0]);
  }
  EXPECT_GT(orders.size(), 30U);
  EXPECT_EQ(first.size(), 5U) << "everyone comes first now and then";
}

}  // namespace
}  // namespace mda::testing
