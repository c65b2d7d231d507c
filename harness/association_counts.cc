#include "harness/association_counts.h"

#include <algorithm>
#include <iterator>

namespace mda {
namespace {

void append_pairs(const ReportTuple& tuple, std::vector<std::pair<int, int>>& pairs) {
  for (std::size_t i = 0; i < tuple.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) pairs.emplace_back(tuple[j], tuple[i]);
  }
}

std::optional<double> share(int part, int whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / whole;
}

template <typename T>
int count_common(const std::vector<T>& sorted, const std::vector<T>& others) {
  return static_cast<int>(std::ranges::count_if(
      others, [&](const T& other) { return std::ranges::binary_search(sorted, other); }));
}

}  // namespace

std::optional<double> AssociationCounts::target_exact() const {
  return share(exact_tuples, true_tuples);
}

std::optional<double> AssociationCounts::pair_precision() const {
  return share(right_pairs, answer_pairs);
}

std::optional<double> AssociationCounts::pair_recall() const {
  return share(right_pairs, true_pairs);
}

TrueAssociation::TrueAssociation(std::vector<ReportTuple> tuples) : tuples_(std::move(tuples)) {
  std::ranges::sort(tuples_);
  for (const ReportTuple& tuple : tuples_) append_pairs(tuple, pairs_);
  std::ranges::sort(pairs_);
}

AssociationCounts TrueAssociation::count(const std::vector<ReportTuple>& answer) const {
  std::vector<std::pair<int, int>> pairs;
  for (const ReportTuple& tuple : answer) append_pairs(tuple, pairs);
  return {.true_tuples = static_cast<int>(std::ssize(tuples_)),
          .answer_tuples = static_cast<int>(std::ssize(answer)),
          .exact_tuples = count_common(tuples_, answer),
          .true_pairs = static_cast<int>(std::ssize(pairs_)),
          .answer_pairs = static_cast<int>(std::ssize(pairs)),
          .right_pairs = count_common(pairs_, pairs)};
}

}  // namespace mda
