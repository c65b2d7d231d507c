// All algorithms' turns at one window, and what the referee makes of them together.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/catalog.h"
#include "harness/referee.h"
#include "harness/sweep.h"

namespace mda {

/// A catalogue entry with its solver. The solver belongs to one thread.
struct Player {
  const CatalogEntry* entry = nullptr;
  bool asked = true;  ///< its row is written; otherwise it only drives or serves as the reference
  std::unique_ptr<Associator> solver;
};

/// One player's turn at one window.
struct Attempt {
  const Player* player = nullptr;
  bool skipped = false;
  Solution solution;
  double wall_ms = 0.0;
  double cpu_ms = 0.0;
  double spent_cpu_ms = 0.0;  ///< of all repeats together

  // Filled in by judge().
  Status claimed = Status::kNoAnswer;  ///< the solver's own word, before the referee's
  Examination examined;
  std::optional<double> certified_bound;
  bool refuted = false;
  std::string note;
};

/// Whether it answered with a choice in which the referee found no fault.
[[nodiscard]] bool is_verified_choice(const Attempt& attempt);

/// What the window's rows have in common.
struct Verdicts {
  std::vector<Attempt> attempts;  ///< in the order of the players
  /// Cost of the reference's answer, or if it has none of the best known choice.
  std::optional<double> reference_cost;
  bool reference_proven = false;
  /// The largest difference between the costs of the exact players that finished, when there were
  /// two or more.
  std::optional<double> exact_spread;
};

/// What every player is asked alike.
struct SolveTerms {
  double time_limit_s = 10.0;  ///< of wall clock, each time
  std::uint64_t seed = 1;
  int repeats = 1;  ///< of a solve below kShortSolveMs; the fastest counts
};

[[nodiscard]] inline SolveTerms terms_of(const Sweep& sweep) {
  return {sweep.time_limit_s, sweep.seed, sweep.repeats};
}

/// CPU time, milliseconds.
inline constexpr double kShortSolveMs = 30.0;

/// One player's turn. Whatever it throws becomes its note; so does an answer that is not the same
/// every time.
[[nodiscard]] Attempt solve_one(const AssociationProblem& problem, const Player& player,
                                const SolveTerms& terms);

/// Lets every player solve the problem, in an order that depends on the problem alone and differs
/// from one to the next: always the same order would favour some.
[[nodiscard]] std::vector<Attempt> solve_all(const AssociationProblem& problem,
                                             const std::vector<Player>& players,
                                             const SolveTerms& terms);

/// Examines all attempts; a refuted claim turns its status into failed.
[[nodiscard]] Verdicts judge(const AssociationProblem& problem, std::vector<Attempt> attempts);

/// What the next window is to follow from.
struct Decision {
  std::vector<double> x;      ///< a choice of columns
  std::vector<Tuple> tuples;  ///< and sequences beside them
  bool fell_back = false;     ///< it is not the driver's
};

/// The answer that advances the window: that of `driver` if it is a choice, else the best one
/// known, else nothing.
[[nodiscard]] Decision advancing_choice(const AssociationProblem& problem, const Verdicts& verdicts,
                                        std::string_view driver);

}  // namespace mda
