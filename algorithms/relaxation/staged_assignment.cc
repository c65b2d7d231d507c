#include "algorithms/relaxation/staged_assignment.h"

#include <algorithm>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kNone = PairOption::kNone;

}  // namespace

StagedAssignment::StagedAssignment(const NormalComponent& component)
    : component_(component), levels_(std::max(2, component.levels())) {
  for (int level = 0; level <= levels_; ++level) {
    const auto first =
        std::lower_bound(component.row_level.begin(), component.row_level.end(), level);
    level_begin_.push_back(static_cast<int>(first - component.row_level.begin()));
  }
  row_at_.assign(index(component.columns() * levels_), kNone);
  for (int j = 0; j < component.columns(); ++j) {
    for (const int row : component.rows_of(j)) {
      const int level = component.row_level[index(row)];
      row_at_[index(j * levels_ + level)] = row - level_begin_[index(level)];
    }
  }
}

int StagedAssignment::row_at(int column, int level) const {
  return row_at_[index(column * levels_ + level)];
}

/// Every row of the first level is a group.
void StagedAssignment::start(std::span<const double> u) {
  groups_ = level_begin_[1];
  group_.resize(index(component_.columns()));
  price_ = component_.cost;
  for (int j = 0; j < component_.columns(); ++j) {
    group_[index(j)] = row_at(j, 0);
    for (const int row : component_.rows_of(j)) {
      if (component_.row_level[index(row)] > 1) price_[index(j)] += u[index(row)];
    }
  }
}

/// Assigns groups to the rows of `level`.
const PairSelection& StagedAssignment::choose(int level) {
  const int rows = level_begin_[index(level) + 1] - level_begin_[index(level)];
  pairs_.first.assign(index(groups_), RowUse::kAtMostOnce);
  pairs_.second.assign(index(rows), RowUse::kAtMostOnce);
  pairs_.options.clear();
  column_of_option_.clear();
  for (int j = 0; j < component_.columns(); ++j) {
    const int group = group_[index(j)];
    const int row = row_at(j, level);
    if (group == kOut || (group == kNoGroup && row == kNone) || price_[index(j)] >= 0.0) continue;
    pairs_.options.push_back({group == kNoGroup ? kNone : group, row, price_[index(j)]});
    column_of_option_.push_back(j);
  }
  return selector_.solve(pairs_);
}

const RelaxedOptimum& StagedAssignment::relax(std::span<const double> u) {
  start(u);
  const PairSelection& selection = choose(1);
  relaxed_.columns.clear();
  for (const int option : selection.chosen) {
    relaxed_.columns.push_back(column_of_option_[index(option)]);
  }
  for (int j = 0; j < component_.columns(); ++j) {
    const bool free = row_at(j, 0) == kNone && row_at(j, 1) == kNone;
    if (free && price_[index(j)] < 0.0) relaxed_.columns.push_back(j);
  }
  relaxed_.multiplier.assign(u.begin(), u.end());
  std::copy(selection.first_multiplier.begin(), selection.first_multiplier.end(),
            relaxed_.multiplier.begin());
  std::copy(selection.second_multiplier.begin(), selection.second_multiplier.end(),
            relaxed_.multiplier.begin() + level_begin_[1]);
  relaxed_.usage.assign(u.size(), 0);
  relaxed_.bound = 0.0;
  for (const int j : relaxed_.columns) {
    relaxed_.bound += price_[index(j)];
    for (const int row : component_.rows_of(j)) ++relaxed_.usage[index(row)];
  }
  for (std::size_t r = index(level_begin_[2]); r < u.size(); ++r) relaxed_.bound -= u[r];
  regroup(1, selection);
  return relaxed_;
}

std::vector<int> StagedAssignment::recover(std::span<const double> u) {
  std::vector<int> chosen;
  if (levels_ == 2) return relaxed_.columns;
  for (int level = 2; level < levels_; ++level) {
    for (int j = 0; j < component_.columns(); ++j) {
      const int row = row_at(j, level);
      if (row != kNone) price_[index(j)] -= u[index(level_begin_[index(level)] + row)];
    }
    const PairSelection& selection = choose(level);
    if (level + 1 < levels_) {
      regroup(level, selection);
    } else {
      for (const int option : selection.chosen) chosen.push_back(column_of_option_[index(option)]);
    }
  }
  return chosen;
}

/// The chosen pairs become the groups.
void StagedAssignment::regroup(int level, const PairSelection& selection) {
  next_group_.assign(index(groups_) + pairs_.second.size(), kOut);
  row_of_group_.assign(index(groups_), kNone);
  int count = 0;
  for (const int o : selection.chosen) {
    const PairOption& option = pairs_.options[index(o)];
    if (option.first == kNone) {
      next_group_[index(groups_ + option.second)] = count++;
    } else {
      next_group_[index(option.first)] = count++;
      row_of_group_[index(option.first)] = option.second;
    }
  }
  for (int j = 0; j < component_.columns(); ++j) {
    int& group = group_[index(j)];
    const int row = row_at(j, level);
    if (group == kNoGroup && row != kNone) {
      group = next_group_[index(groups_ + row)];
    } else if (group >= 0) {
      group = row_of_group_[index(group)] == row ? next_group_[index(group)] : kOut;
    }
  }
  groups_ = count;
}

}  // namespace mda
