// The rows of a window: what was solved, and what the referee makes of each answer.
#pragma once

#include "harness/judge.h"
#include "harness/plan.h"
#include "harness/row.h"
#include "harness/sweep.h"
#include "harness/window_loop.h"

namespace mda {

struct RowContext {
  const Cell& cell;
  const Sweep& sweep;
  int workers = 1;
};

/// The fields that all rows of the loop's present window share.
[[nodiscard]] Row window_row(const RowContext& context, const WindowLoop& windows);

/// `row` of a problem, completed with one attempt at it.
[[nodiscard]] Row attempt_row(Row row, const AssociationProblem& problem, const Attempt& attempt,
                              const Verdicts& verdicts);

/// The same of the loop's present window, and how well the attempt agrees with the truth.
[[nodiscard]] Row attempt_row(Row row, const WindowLoop& windows, const Attempt& attempt,
                              const Verdicts& verdicts);

}  // namespace mda
