#include "harness/own_loop.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace mda {

Verdicts own_verdicts(const WindowLoop& loop, const Player& player, const Sweep& sweep,
                      OwnLoopTally& tally) {
  const AssociationProblem& problem = loop.window().problem;
  std::vector<Attempt> attempts;
  attempts.push_back(solve_one(problem, player, terms_of(sweep)));
  Verdicts verdicts = judge(problem, std::move(attempts));
  const Attempt& judged = verdicts.attempts.front();
  tally.wall_ms += judged.wall_ms;
  tally.cpu_ms += judged.cpu_ms;
  tally.off_column_paths += judged.solution.stats.off_column_paths.value_or(0);
  if (judged.skipped && tally.declined.empty()) tally.declined = judged.note;
  if (judged.solution.status == Status::kFailed) {
    tally.failed = true;
    if (tally.note.empty()) tally.note = fmt::format("scan {}: {}", loop.scan(), judged.note);
  }
  return verdicts;
}

Decision own_turn(const WindowLoop& loop, const Player& player, const Sweep& sweep,
                  OwnLoopTally& tally) {
  const Verdicts verdicts = own_verdicts(loop, player, sweep, tally);
  Decision decision = advancing_choice(loop.window().problem, verdicts, player.entry->name);
  if (decision.fell_back) ++tally.unanswered;
  return decision;
}

}  // namespace mda
