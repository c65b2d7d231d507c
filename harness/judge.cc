#include "harness/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <numeric>

#include "harness/clocks.h"
#include "harness/messages.h"
#include "scenarios/world/draws.h"

namespace mda {
namespace {

/// The players' numbers, shuffled with a key made of the problem.
std::vector<std::size_t> playing_order(const AssociationProblem& problem, std::size_t players) {
  std::vector<std::size_t> order(players);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::uint64_t key = static_cast<std::uint64_t>(problem.rows()) * 31 +
                            static_cast<std::uint64_t>(problem.columns()) * 1009 +
                            static_cast<std::uint64_t>(problem.nonzeros());
  auto engine = draws({.seed = key, .scenario = {}, .purpose = Purpose::kPlayingOrder});
  for (std::size_t left = players; left > 1; --left) {
    std::swap(order[left - 1], order[engine() % left]);
  }
  return order;
}

Solution failure(std::string why) {
  Solution solution;
  solution.status = Status::kFailed;
  solution.stop = Stop::kError;
  solution.note = std::move(why);
  return solution;
}

bool answered(const Attempt& attempt) {
  return !attempt.skipped && (attempt.solution.status == Status::kOptimal ||
                              attempt.solution.status == Status::kFeasible);
}

/// The cheapest choice of columns that anybody found and the referee verified; doing nothing counts
/// where it is allowed. A sequence that is no column is not for the others to beat.
Knowledge gather_knowledge(const AssociationProblem& problem,
                           const std::vector<Attempt>& attempts) {
  Knowledge known;
  if (!problem.shape().has_exactly_once_rows) known.best_choice_cost = 0.0;
  for (const Attempt& attempt : attempts) {
    if (!is_verified_choice(attempt) || !attempt.solution.tuples.empty()) continue;
    known.best_choice_cost = std::min(known.best_choice_cost, attempt.examined.cost);
  }
  return known;
}

std::optional<double> spread_of_exact(const std::vector<Attempt>& attempts) {
  std::vector<double> costs;
  for (const Attempt& attempt : attempts) {
    if (!is_verified_choice(attempt) || attempt.solution.status != Status::kOptimal) continue;
    if (attempt.player->solver->traits().exact) costs.push_back(attempt.examined.cost);
  }
  if (costs.size() < 2) return std::nullopt;
  const auto [least, most] = std::minmax_element(costs.begin(), costs.end());
  return *most - *least;
}

Attempt solve_once(const AssociationProblem& problem, const Player& player,
                   const SolveTerms& terms) {
  Attempt attempt;
  attempt.player = &player;
  Stopwatch watch;
  try {
    const Verdict verdict = player.solver->can_solve(problem.shape());
    if (!verdict.ok) {
      attempt.skipped = true;
      attempt.note = verdict.reason;
      return attempt;
    }
    Budget budget;
    budget.seed = terms.seed;
    const std::chrono::duration<double> limit(std::min(terms.time_limit_s, 1e9));
    budget.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
    watch = Stopwatch();
    attempt.solution = player.solver->solve(problem, budget);
  } catch (const std::exception& error) {
    attempt.solution = failure(plain_words(error));
  } catch (...) {
    attempt.solution = failure("it threw something that is not an exception");
  }
  attempt.wall_ms = watch.wall_ms();
  attempt.cpu_ms = watch.cpu_ms();
  attempt.spent_cpu_ms = attempt.cpu_ms;
  attempt.note = attempt.solution.note;
  return attempt;
}

bool is_short(const Attempt& attempt) {
  return answered(attempt) && attempt.solution.stop == Stop::kFinished &&
         attempt.cpu_ms < kShortSolveMs;
}

bool same_answer(const Solution& a, const Solution& b) {
  return a.status == b.status && a.x == b.x && a.tuples == b.tuples;
}

}  // namespace

bool is_verified_choice(const Attempt& attempt) {
  return answered(attempt) && !attempt.refuted && attempt.solution.answer == Answer::kSelection &&
         attempt.examined.is_choice();
}

Attempt solve_one(const AssociationProblem& problem, const Player& player,
                  const SolveTerms& terms) {
  Attempt attempt = solve_once(problem, player, terms);
  for (int turn = 1; turn < terms.repeats && is_short(attempt); ++turn) {
    Attempt again = solve_once(problem, player, terms);
    if (again.solution.stop == Stop::kDeadline) {  // bad luck once: the answer stands
      attempt.spent_cpu_ms += again.spent_cpu_ms;
      break;
    }
    if (!same_answer(attempt.solution, again.solution)) {
      attempt.solution = failure("asked again, it gave another answer");
      attempt.note = attempt.solution.note;
      return attempt;
    }
    const double spent_cpu_ms = attempt.spent_cpu_ms + again.spent_cpu_ms;
    if (again.cpu_ms < attempt.cpu_ms) attempt = std::move(again);
    attempt.spent_cpu_ms = spent_cpu_ms;
  }
  return attempt;
}

std::vector<Attempt> solve_all(const AssociationProblem& problem,
                               const std::vector<Player>& players, const SolveTerms& terms) {
  std::vector<Attempt> attempts(players.size());
  for (const std::size_t i : playing_order(problem, players.size())) {
    attempts[i] = solve_one(problem, players[i], terms);
  }
  return attempts;
}

Verdicts judge(const AssociationProblem& problem, std::vector<Attempt> attempts) {
  Verdicts verdicts;
  for (Attempt& attempt : attempts) {
    attempt.claimed = attempt.solution.status;
    if (!answered(attempt)) continue;
    attempt.examined = examine(problem, attempt.solution.x, attempt.solution.tuples);
    attempt.certified_bound = certified_bound(problem, attempt.solution.row_dual);
  }
  const Knowledge known = gather_knowledge(problem, attempts);
  for (Attempt& attempt : attempts) {
    if (attempt.skipped) continue;
    std::string reason = refutation(attempt.solution, attempt.examined, known);
    if (reason.empty()) reason = ranking_fault(problem, attempt.solution);
    if (reason.empty()) continue;
    attempt.refuted = true;
    attempt.note = reason;
    attempt.solution.status = Status::kFailed;
  }
  if (std::isfinite(known.best_choice_cost)) verdicts.reference_cost = known.best_choice_cost;
  for (const Attempt& attempt : attempts) {
    if (!attempt.player->entry->reference || !is_verified_choice(attempt)) continue;
    verdicts.reference_cost = attempt.examined.cost;
    verdicts.reference_proven = attempt.solution.status == Status::kOptimal;
  }
  verdicts.exact_spread = spread_of_exact(attempts);
  verdicts.attempts = std::move(attempts);
  return verdicts;
}

Decision advancing_choice(const AssociationProblem& problem, const Verdicts& verdicts,
                          std::string_view driver) {
  const Attempt* best = nullptr;
  for (const Attempt& attempt : verdicts.attempts) {
    if (!is_verified_choice(attempt)) continue;
    if (attempt.player->entry->name == driver) {
      return {attempt.solution.x, attempt.solution.tuples, false};
    }
    if (best == nullptr || attempt.examined.cost < best->examined.cost) best = &attempt;
  }
  if (best != nullptr) return {best->solution.x, best->solution.tuples, true};
  return {std::vector<double>(static_cast<std::size_t>(problem.columns()), 0.0), {}, true};
}

}  // namespace mda
