#include "algorithms/backends/pair_selection.h"

#include <algorithm>
#include <limits>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double cost_of_nothing(RowUse use) {
  return use == RowUse::kAtMostOnce ? 0.0 : kInfinity;
}

}  // namespace

const PairSelection& PairSelector::solve(const PairProblem& problem) {
  find_rests(problem);
  group_pairs(problem);
  const bool twofold = std::any_of(second_rest_.begin(), second_rest_.end(),
                                   [](const Rest& rest) { return rest.cost == kInfinity; });
  costs_.row_begin.assign(1, 0);
  costs_.column.clear();
  costs_.cost.clear();
  costs_.alone.clear();
  if (twofold) {
    fill_twofold(problem);
  } else {
    fill_plain(problem);
  }
  const Assignment& assignment = solver_.solve(costs_);

  const std::size_t firsts = problem.first.size();
  const std::size_t seconds = problem.second.size();
  result_.feasible = assignment.feasible;
  result_.first_multiplier.resize(firsts);
  result_.second_multiplier.resize(seconds);
  for (std::size_t a = 0; a < firsts; ++a) {
    const double stand_in = twofold ? assignment.column_price[seconds + a] : 0.0;
    result_.first_multiplier[a] = stand_in - assignment.row_price[a];
  }
  for (std::size_t b = 0; b < seconds; ++b) {
    const double rest = twofold ? assignment.row_price[firsts + b] : second_rest_[b].cost;
    result_.second_multiplier[b] = assignment.column_price[b] - rest;
  }
  choose(problem, assignment);
  return result_;
}

void PairSelector::find_rests(const PairProblem& problem) {
  const auto start = [](const std::vector<RowUse>& uses, std::vector<Rest>& rests) {
    rests.clear();
    for (const RowUse use : uses) rests.push_back({cost_of_nothing(use), PairOption::kNone});
  };
  start(problem.first, first_rest_);
  start(problem.second, second_rest_);
  for (std::size_t o = 0; o < problem.options.size(); ++o) {
    const PairOption& option = problem.options[o];
    if (option.first != PairOption::kNone && option.second != PairOption::kNone) continue;
    Rest& rest = option.first != PairOption::kNone ? first_rest_[index(option.first)]
                                                   : second_rest_[index(option.second)];
    if (option.cost < rest.cost) rest = {option.cost, static_cast<int>(o)};
  }
}

/// Sorts the pairs by their first row. Pairs that are not better than leaving both rows out of all
/// pairs are left away: the optimum and the validity of its multipliers do not need them.
void PairSelector::group_pairs(const PairProblem& problem) {
  const auto worth = [&](const PairOption& option) {
    return option.first != PairOption::kNone && option.second != PairOption::kNone &&
           option.cost <
               first_rest_[index(option.first)].cost + second_rest_[index(option.second)].cost;
  };
  pair_begin_.assign(problem.first.size() + 1, 0);
  for (const PairOption& option : problem.options) {
    if (worth(option)) ++pair_begin_[index(option.first) + 1];
  }
  for (std::size_t a = 0; a < problem.first.size(); ++a) pair_begin_[a + 1] += pair_begin_[a];
  pairs_.resize(index(pair_begin_.back()));
  for (std::size_t o = 0; o < problem.options.size(); ++o) {
    const PairOption& option = problem.options[o];
    if (worth(option)) pairs_[index(pair_begin_[index(option.first)]++)] = static_cast<int>(o);
  }
  // The starts have moved to the ends.
  for (std::size_t a = problem.first.size(); a > 0; --a) pair_begin_[a] = pair_begin_[a - 1];
  pair_begin_[0] = 0;
}

void PairSelector::add_entry(int column, double cost) {
  costs_.column.push_back(column);
  costs_.cost.push_back(cost);
}

/// A row of the second side that is in no pair costs its rest whatever else happens, so pairs are
/// charged the difference.
void PairSelector::fill_plain(const PairProblem& problem) {
  costs_.columns = static_cast<int>(problem.second.size());
  for (std::size_t a = 0; a < problem.first.size(); ++a) {
    for (int p = pair_begin_[a]; p < pair_begin_[a + 1]; ++p) {
      const PairOption& option = problem.options[index(pairs_[index(p)])];
      add_entry(option.second, option.cost - second_rest_[index(option.second)].cost);
    }
    costs_.row_begin.push_back(static_cast<int>(costs_.column.size()));
    costs_.alone.push_back(first_rest_[a].cost);
  }
}

/// Every row gets a stand-in on the other side, which it takes instead of being in a pair; the
/// stand-ins of a pair take each other at no cost. All rows and all columns must be used then.
void PairSelector::fill_twofold(const PairProblem& problem) {
  const int firsts = static_cast<int>(problem.first.size());
  const int seconds = static_cast<int>(problem.second.size());
  costs_.columns = seconds + firsts;
  std::vector<std::vector<int>> partners(index(seconds));
  for (int a = 0; a < firsts; ++a) {
    for (int p = pair_begin_[index(a)]; p < pair_begin_[index(a) + 1]; ++p) {
      const PairOption& option = problem.options[index(pairs_[index(p)])];
      add_entry(option.second, option.cost);
      partners[index(option.second)].push_back(a);
    }
    const double rest = first_rest_[index(a)].cost;
    if (rest < kInfinity) add_entry(seconds + a, rest);
    costs_.row_begin.push_back(static_cast<int>(costs_.column.size()));
  }
  for (int b = 0; b < seconds; ++b) {
    for (const int a : partners[index(b)]) add_entry(seconds + a, 0.0);
    const double rest = second_rest_[index(b)].cost;
    if (rest < kInfinity) add_entry(b, rest);
    costs_.row_begin.push_back(static_cast<int>(costs_.column.size()));
  }
  costs_.alone.assign(index(firsts + seconds), kInfinity);
}

void PairSelector::choose(const PairProblem& problem, const Assignment& assignment) {
  result_.chosen.clear();
  if (!assignment.feasible) return;
  const int seconds = static_cast<int>(problem.second.size());
  second_in_pair_.assign(index(seconds), 0);
  const auto take = [&](int option) {
    if (option != PairOption::kNone) result_.chosen.push_back(option);
  };
  for (int a = 0; a < static_cast<int>(problem.first.size()); ++a) {
    const int column = assignment.column_of_row[index(a)];
    if (column == Assignment::kAlone || column >= seconds) {
      take(first_rest_[index(a)].option);
    } else {
      take(pair_option(problem, a, column));
      second_in_pair_[index(column)] = 1;
    }
  }
  for (int b = 0; b < seconds; ++b) {
    if (second_in_pair_[index(b)] == 0) take(second_rest_[index(b)].option);
  }
  std::sort(result_.chosen.begin(), result_.chosen.end());
}

/// The cheapest of the pair.
int PairSelector::pair_option(const PairProblem& problem, int first, int second) const {
  int best = PairOption::kNone;
  for (int p = pair_begin_[index(first)]; p < pair_begin_[index(first) + 1]; ++p) {
    const int o = pairs_[index(p)];
    if (problem.options[index(o)].second != second) continue;
    if (best == PairOption::kNone ||
        problem.options[index(o)].cost < problem.options[index(best)].cost) {
      best = o;
    }
  }
  return best;
}

}  // namespace mda
