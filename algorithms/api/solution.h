// What an algorithm answers. There is no cost in it: the referee recomputes costs
// (harness/referee).
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/api/certificate.h"
#include "algorithms/api/views.h"

namespace mda {

/// What x is: a choice of columns, a point of the LP relaxation, or probabilities.
enum class Answer : std::uint8_t { kSelection, kRelaxation, kMarginals };

/// What is known about x. Whatever an algorithm does not know, the harness finds out.
enum class Status : std::uint8_t {
  kOptimal,   ///< proven optimal for the algorithm's own question (a relaxation: of the LP)
  kFeasible,  ///< an answer without proof
  kNoAnswer,  ///< stopped without one
  kFailed     ///< an exception, or a claim that the referee refuted
};

/// Why it ended.
enum class Stop : std::uint8_t { kFinished, kDeadline, kIterationLimit, kError };

/// Work done, as far as the algorithm has such a thing. Times in milliseconds of wall clock.
struct Stats {
  std::optional<std::int64_t> iterations;  ///< simplex iterations
  std::optional<std::int64_t> nodes;       ///< of branch and bound
  std::optional<double> translate_ms;      ///< copying the problem into a library's own form
  std::optional<double> lp_ms;
  std::optional<double> round_ms;
  std::optional<double> graph_ms;       ///< making a layered graph out of the hypothesis tree
  std::optional<int> lp_fractional;     ///< values of the algorithm's own LP that are not whole
  std::optional<int> off_column_paths;  ///< tracks of the answer whose sequence is no column
  std::optional<int> graph_nodes;
  std::optional<int> graph_arcs;
};

/// One of several choices, without its cost: the referee computes that.
using Choice = std::vector<int>;  ///< columns, ascending

struct Solution {
  Status status = Status::kNoAnswer;
  Stop stop = Stop::kFinished;
  Answer answer = Answer::kSelection;
  std::vector<double> x;  ///< one per column, in [0, 1]; empty without an answer
  /// Beside the columns of x: sequences of fixed tracks, or tuples of sensors' reports, that are no
  /// columns. Only where the problem's views know the cost of such a thing.
  std::vector<Tuple> tuples;
  /// The k best choices, the best (which is x) first, of algorithms that rank them.
  std::vector<Choice> ranked;
  /// The optimal basic LP point that a selection was made from, when there was one: one per column.
  /// The referee counts the fractional columns of it, or of x if x is itself a relaxation.
  std::vector<double> relaxation;
  double lower_bound = -std::numeric_limits<double>::infinity();  ///< claimed, nats
  /// Multipliers that certify a bound (AssociationProblem's rows): empty, or one per row,
  /// not negative on at-most-once rows.
  std::vector<double> row_dual;
  /// The proof that x is optimal, of algorithms that write it down.
  std::shared_ptr<const Certificate> certificate;
  Stats stats;
  std::string note;  ///< for people; never parsed
};

/// The words of the row files: "selection", "optimal", "finished", ...
[[nodiscard]] std::string_view word(Answer answer) noexcept;
[[nodiscard]] std::string_view word(Status status) noexcept;
[[nodiscard]] std::string_view word(Stop stop) noexcept;

/// How far two costs near `cost` may differ before the difference is news, nats.
[[nodiscard]] double cost_tolerance(double cost) noexcept;

/// The solution that selects `columns` out of `column_count`.
[[nodiscard]] Solution selection_of(const std::vector<int>& columns, int column_count,
                                    Status status);

}  // namespace mda
