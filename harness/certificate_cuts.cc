#include "harness/certificate_cuts.h"

#include <algorithm>
#include <set>

namespace mda {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool rivals(const AssociationProblem& problem, int a, int b) {
  const auto rows = problem.rows_of(a);
  const auto others = problem.rows_of(b);
  return std::ranges::find_first_of(rows, others) != rows.end();
}

void CertificateCuts::add_odd_rows(std::span<const int> rows) {
  const std::set<int> different(rows.begin(), rows.end());
  demand(different.size() == rows.size() && rows.size() % 2 == 1, "a cut needs an odd set of rows");
  odd_of_row_.resize(index(problem_->rows()));
  for (const int r : rows) odd_of_row_[index(r)].push_back(count());
  add(std::ssize(rows) / 2);
}

void CertificateCuts::add_clique(std::span<const int> columns) {
  cliques_of_column_.resize(index(problem_->columns()));
  for (std::size_t a = 0; a < columns.size(); ++a) {
    cliques_of_column_[index(columns[a])].push_back(count());
    for (std::size_t b = 0; b < a; ++b) {
      demand(columns[a] != columns[b] && rivals(*problem_, columns[a], columns[b]),
             "two columns of a clique share no row");
    }
  }
  add(1);
}

void CertificateCuts::add(std::int64_t right_hand_side) {
  right_hand_side_.push_back(right_hand_side);
  price_.push_back(0);
  hits_.push_back(0);
}

std::int64_t CertificateCuts::price_of(int column) {
  std::int64_t sum = 0;
  if (!odd_of_row_.empty()) {
    const auto rows = problem_->rows_of(column);
    for (const int r : rows) {
      for (const int k : odd_of_row_[index(r)]) {
        if (++hits_[index(k)] % 2 == 0) sum += price_[index(k)];
      }
    }
    for (const int r : rows) {
      for (const int k : odd_of_row_[index(r)]) hits_[index(k)] = 0;
    }
  }
  if (!cliques_of_column_.empty()) {
    for (const int k : cliques_of_column_[index(column)]) sum += price_[index(k)];
  }
  return sum;
}

}  // namespace mda
