// answers.jsonl: what an algorithm answered, as far as it is needed to judge the answer again.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "harness/judge.h"
#include "harness/row.h"

namespace mda {

/// A line of answers.jsonl: the columns used (with their values unless all are 1), those of the LP
/// point that the answer was made from, sequences that are no columns, ranked choices, counts that
/// only the solver knows, the claimed bound and its multipliers. There is one for
/// each algorithm that ran; also for the driver and the reference if their rows were not asked for,
/// whether they ran or not: with the row that rows.jsonl would have, so that they can be checked.
void append_answer_line(const Row& row, const Attempt& attempt, std::string& text);

/// Reads such a line back as the answer to a problem of `columns` columns. Throws
/// std::invalid_argument, which names the field that is absent or wrong.
[[nodiscard]] Solution solution_of(const nlohmann::json& answer, int columns);

}  // namespace mda
