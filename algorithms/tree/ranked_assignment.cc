#include "algorithms/tree/ranked_assignment.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kNotReached = -1;

}  // namespace

bool RankedAssignments::ComesLater::operator()(const Part& a, const Part& b) const {
  return std::tie(a.best.cost, a.best.column_of_row) > std::tie(b.best.cost, b.best.column_of_row);
}

RankedAssignments::RankedAssignments(SparseCosts costs, AssignmentSolver& solver)
    : costs_(std::move(costs)),
      solver_(solver),
      taken_(index(costs_.columns), 0),
      row_reached_(index(costs_.rows()), 0),
      column_in_part_(index(costs_.columns), kNotReached) {
  list_rows_of_columns();
  const Assignment& best = solver_.solve(costs_);
  if (!best.feasible) return;
  parts_.push({{cost_of(best.column_of_row), best.column_of_row}, 0, {}});
}

void RankedAssignments::list_rows_of_columns() {
  rows_begin_.assign(index(costs_.columns) + 1, 0);
  for (const int j : costs_.column) ++rows_begin_[index(j) + 1];
  for (std::size_t j = 1; j < rows_begin_.size(); ++j) rows_begin_[j] += rows_begin_[j - 1];
  rows_.resize(costs_.column.size());
  std::vector<int> end = rows_begin_;
  for (int i = 0; i < costs_.rows(); ++i) {
    for (int e = costs_.row_begin[index(i)]; e < costs_.row_begin[index(i) + 1]; ++e) {
      rows_[index(end[index(costs_.column[index(e)])]++)] = i;
    }
  }
}

RankedAssignment RankedAssignments::take() {
  Part part = parts_.top();
  parts_.pop();
  split(part);
  return std::move(part.best);
}

void RankedAssignments::split(const Part& part) {
  std::fill(taken_.begin(), taken_.end(), 0);
  Part rest = part;
  for (int i = 0; i < costs_.rows(); ++i) {
    const int column = part.best.column_of_row[index(i)];
    if (i >= part.fixed) {
      rest.fixed = i;
      if (i > part.fixed) rest.forbidden.clear();
      rest.forbidden.push_back(column);
      if (auto best = best_of(rest)) parts_.push({std::move(*best), i, rest.forbidden});
    }
    if (column != Assignment::kAlone) taken_[index(column)] = 1;
  }
}

/// part.best is still the best of the rows that do not hang together with row `fixed`.
std::optional<RankedAssignment> RankedAssignments::best_of(const Part& part) {
  reach(part.fixed);
  gather(part);
  for (const int i : reached_rows_) row_reached_[index(i)] = 0;
  for (const int j : reached_columns_) column_in_part_[index(j)] = kNotReached;
  if (open_.alone[0] == kInfinity && open_.row_begin[1] == 0) return std::nullopt;
  const Assignment& found = solver_.solve(open_);
  if (!found.feasible) return std::nullopt;
  RankedAssignment best;
  best.column_of_row = part.best.column_of_row;
  for (std::size_t i = 0; i < reached_rows_.size(); ++i) {
    const int column = found.column_of_row[i];
    best.column_of_row[index(reached_rows_[i])] =
        column == Assignment::kAlone ? Assignment::kAlone : reached_columns_[index(column)];
  }
  best.cost = cost_of(best.column_of_row);
  return best;
}

/// Lists the later rows that hang together with `first_row` by columns that are not taken, and
/// numbers these columns. The forbidden ones count: others may take them now.
void RankedAssignments::reach(int first_row) {
  reached_rows_.assign(1, first_row);
  reached_columns_.clear();
  row_reached_[index(first_row)] = 1;
  for (std::size_t next = 0; next < reached_rows_.size(); ++next) {
    const int i = reached_rows_[next];
    for (int e = costs_.row_begin[index(i)]; e < costs_.row_begin[index(i) + 1]; ++e) {
      const int j = costs_.column[index(e)];
      if (taken_[index(j)] != 0 || column_in_part_[index(j)] != kNotReached) continue;
      column_in_part_[index(j)] = static_cast<int>(reached_columns_.size());
      reached_columns_.push_back(j);
      for (int r = rows_begin_[index(j)]; r < rows_begin_[index(j) + 1]; ++r) {
        const int other = rows_[index(r)];
        if (other < first_row || row_reached_[index(other)] != 0) continue;
        row_reached_[index(other)] = 1;
        reached_rows_.push_back(other);
      }
    }
  }
}

/// Fills open_ with the reached rows and columns.
void RankedAssignments::gather(const Part& part) {
  const auto forbidden = [&](int column) {
    return std::find(part.forbidden.begin(), part.forbidden.end(), column) != part.forbidden.end();
  };
  open_.columns = static_cast<int>(reached_columns_.size());
  open_.row_begin.assign(1, 0);
  open_.column.clear();
  open_.cost.clear();
  open_.alone.clear();
  for (const int i : reached_rows_) {
    const bool first = i == part.fixed;
    for (int e = costs_.row_begin[index(i)]; e < costs_.row_begin[index(i) + 1]; ++e) {
      const int j = costs_.column[index(e)];
      if (taken_[index(j)] != 0 || (first && forbidden(j))) continue;
      open_.column.push_back(column_in_part_[index(j)]);
      open_.cost.push_back(costs_.cost[index(e)]);
    }
    open_.row_begin.push_back(static_cast<int>(open_.column.size()));
    const bool must = first && forbidden(Assignment::kAlone);
    open_.alone.push_back(must ? kInfinity : costs_.alone[index(i)]);
  }
}

/// Summed in the order of the rows, so that equal assignments cost the same to the last bit.
double RankedAssignments::cost_of(const std::vector<int>& column_of_row) const {
  double cost = 0.0;
  for (int i = 0; i < costs_.rows(); ++i) {
    const int column = column_of_row[index(i)];
    double of_row = column == Assignment::kAlone ? costs_.alone[index(i)] : kInfinity;
    for (int e = costs_.row_begin[index(i)]; e < costs_.row_begin[index(i) + 1]; ++e) {
      if (costs_.column[index(e)] == column) of_row = std::min(of_row, costs_.cost[index(e)]);
    }
    cost += of_row;
  }
  return cost;
}

}  // namespace mda
