// How well an answer's tuples of reports agree with the truth.
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace mda {

/// Pooled over windows: divide sums by sums.
struct AssociationCounts {
  int true_tuples = 0;    ///< targets that two sensors at least have seen
  int answer_tuples = 0;  ///< of the answer
  int exact_tuples = 0;   ///< in both, with the same reports
  int true_pairs = 0;     ///< of reports of one target
  int answer_pairs = 0;   ///< of reports in one tuple of the answer
  int right_pairs = 0;    ///< in both

  /// exact_tuples / true_tuples: target-exact correct association. Nothing without true tuples.
  [[nodiscard]] std::optional<double> target_exact() const;
  /// right_pairs / answer_pairs.
  [[nodiscard]] std::optional<double> pair_precision() const;
  /// right_pairs / true_pairs.
  [[nodiscard]] std::optional<double> pair_recall() const;
};

/// The rows of the reports that are one target, ascending, two at least.
using ReportTuple = std::vector<int>;

/// Compares answers with one truth.
class TrueAssociation {
 public:
  TrueAssociation() = default;
  explicit TrueAssociation(std::vector<ReportTuple> tuples);

  /// `answer`: no report in two tuples.
  [[nodiscard]] AssociationCounts count(const std::vector<ReportTuple>& answer) const;

  [[nodiscard]] const std::vector<ReportTuple>& tuples() const noexcept { return tuples_; }

 private:
  std::vector<ReportTuple> tuples_;         ///< ascending
  std::vector<std::pair<int, int>> pairs_;  ///< ascending
};

}  // namespace mda
