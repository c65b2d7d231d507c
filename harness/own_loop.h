// What every algorithm goes through that drives its own windows, whatever they are made of.
#pragma once

#include <string>

#include "harness/judge.h"
#include "harness/sweep.h"
#include "harness/window_loop.h"

namespace mda {

/// How it went so far.
struct OwnLoopTally {
  int unanswered = 0;  ///< windows without a usable answer: nothing was chosen there
  int off_column_paths = 0;
  double wall_ms = 0.0;  ///< of solving
  double cpu_ms = 0.0;
  std::string declined;  ///< why it declined the first window that it did
  bool failed = false;   ///< it threw, or was refuted
  std::string note;      ///< the first time that it failed
};

/// The player's turn at the loop's present window, judged alone and added to the tally.
[[nodiscard]] Verdicts own_verdicts(const WindowLoop& loop, const Player& player,
                                    const Sweep& sweep, OwnLoopTally& tally);

/// The same: its choice, or nothing chosen.
[[nodiscard]] Decision own_turn(const WindowLoop& loop, const Player& player, const Sweep& sweep,
                                OwnLoopTally& tally);

}  // namespace mda
