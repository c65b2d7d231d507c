#include "algorithms/certified/cut_lp.h"

#include <algorithm>
#include <cmath>

#include "algorithms/certified/column_generation.h"
#include "algorithms/certified/first_columns.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kNone = -1;

}  // namespace

CutLp::CutLp(const Packing& packing, std::span<const Steps> reduced, const Budget& budget)
    : packing_(packing),
      budget_(budget),
      lp_(packing.rows()),
      lp_column_(packing.cost.size(), kNone),
      alive_(packing.cost.size(), 1),
      cuts_of_column_(packing.cost.size()) {
  for (const int j : first_columns(packing, reduced)) enter(j);
  pricing_.reduced.assign(packing.cost.size(), kDead);
  pricing_.least.resize(packing.root.size());
  for (int t = 0; t < packing.trees(); ++t) {
    for (int j = packing.tree_begin[index(t)]; j < packing.tree_begin[index(t) + 1]; ++j) {
      living_.push_back(j);
      tree_of_column_.push_back(t);
    }
  }
}

void CutLp::enter(int column) {
  entries_.clear();
  for (const int r : packing_.rows_of(column)) entries_.push_back({r, 1.0});
  for (int k = 0; k < std::ssize(cut_of_lp_row_); ++k) {
    for (const auto& [cut, coefficient] : cuts_of_column_[index(column)]) {
      if (cut != cut_of_lp_row_[index(k)]) continue;
      entries_.push_back({packing_.rows() + k, static_cast<double>(coefficient)});
    }
  }
  lp_.add_column(units(packing_.cost[index(column)]), entries_);
  lp_column_[index(column)] = static_cast<int>(column_of_lp_.size());
  column_of_lp_.push_back(column);
  method_ = GrowingLp::Method::kPrimal;
}

void CutLp::add(Cut cut) {
  const int number = cuts();
  entries_.clear();
  for (const auto& [column, coefficient] : cut.columns) {
    cuts_of_column_[index(column)].emplace_back(number, coefficient);
    if (lp_column_[index(column)] == kNone) continue;
    entries_.push_back({lp_column_[index(column)], static_cast<double>(coefficient)});
  }
  lp_.add_row(cut.right_hand_side, entries_);
  cut_of_lp_row_.push_back(number);
  cuts_.push_back(std::move(cut));
  cut_prices_.push_back(0);
  method_ = GrowingLp::Method::kDual;
}

void CutLp::drop_slack_cuts() {
  std::vector<int> rows;
  std::vector<int> kept;
  for (int k = 0; k < std::ssize(cut_of_lp_row_); ++k) {
    const int number = cut_of_lp_row_[index(k)];
    if (cut_prices_[index(number)] > 0 || !lp_.is_slack(packing_.rows() + k)) {
      kept.push_back(number);
      continue;
    }
    rows.push_back(packing_.rows() + k);
    for (const auto& [column, coefficient] : cuts_[index(number)].columns) {
      std::erase_if(cuts_of_column_[index(column)],
                    [&](const auto& entry) { return entry.first == number; });
    }
  }
  if (rows.empty()) return;
  lp_.remove_rows(rows);
  cut_of_lp_row_ = std::move(kept);
}

void CutLp::kill(int column) {
  alive_[index(column)] = 0;
  if (lp_column_[index(column)] == kNone) return;
  lp_.forbid(lp_column_[index(column)], true);
  method_ = GrowingLp::Method::kDual;
}

void CutLp::revive(int column) {
  alive_[index(column)] = 1;
  if (lp_column_[index(column)] == kNone) return;
  lp_.forbid(lp_column_[index(column)], false);
  method_ = GrowingLp::Method::kDual;
}

void CutLp::bury_the_dead() {
  std::erase_if(living_, [&](int j) { return !is_alive(j); });
  std::vector<int> buried;
  std::vector<int> kept;
  for (int k = 0; k < std::ssize(column_of_lp_); ++k) {
    const int j = column_of_lp_[index(k)];
    if (is_alive(j)) {
      lp_column_[index(j)] = static_cast<int>(kept.size());
      kept.push_back(j);
    } else {
      lp_column_[index(j)] = kNone;
      buried.push_back(k);
    }
  }
  if (buried.empty()) return;
  lp_.remove_columns(buried);
  column_of_lp_ = std::move(kept);
}

Outcome CutLp::solve(Steps ceiling) {
  for (;;) {
    const Outcome outcome = lp_.solve(method_, budget_);
    if (outcome != Outcome::kOptimal) return outcome;
    price_all();
    if (bound() > ceiling - kGrid || !enter_columns_that_gain()) return Outcome::kOptimal;
  }
}

double CutLp::units(Steps cost) noexcept { return static_cast<double>(cost) / kStepsPerLpUnit; }

double CutLp::value_without(std::span<const int> columns, int most_steps) {
  std::vector<int> entered;
  for (const int j : columns) {
    if (lp_column_[index(j)] != kNone) entered.push_back(lp_column_[index(j)]);
  }
  return lp_.value_without(entered, most_steps, budget_);
}

void CutLp::price_all() {
  const std::vector<double> multipliers = lp_.multipliers();
  const auto steps = [&](int row) -> Steps {
    return std::llround(multipliers[index(row)] * kStepsPerLpUnit);
  };
  prices_.resize(index(packing_.rows()));
  for (int r = 0; r < packing_.rows(); ++r) prices_[index(r)] = steps(r);
  Steps paid = 0;
  for (const Steps y : prices_) paid += y;
  for (const int j : living_) {
    Steps reduced = kDead;
    if (is_alive(j)) {
      reduced = packing_.cost[index(j)];
      for (const int r : packing_.rows_of(j)) reduced += prices_[index(r)];
    }
    pricing_.reduced[index(j)] = reduced;
  }
  std::ranges::fill(cut_prices_, 0);
  for (int k = 0; k < std::ssize(cut_of_lp_row_); ++k) {
    const int number = cut_of_lp_row_[index(k)];
    const Steps w = steps(packing_.rows() + k);
    cut_prices_[index(number)] = w;
    paid += w * cuts_[index(number)].right_hand_side;
    if (w == 0) continue;
    for (const auto& [column, coefficient] : cuts_[index(number)].columns) {
      if (is_alive(column)) pricing_.reduced[index(column)] += w * coefficient;
    }
  }
  find_bound(paid);
}

void CutLp::find_bound(Steps paid) {
  std::ranges::fill(pricing_.least, kDead);
  for (const int j : living_) {
    Steps& least = pricing_.least[index(tree_of_column_[index(j)])];
    least = std::min(least, pricing_.reduced[index(j)]);
  }
  pricing_.bound = -paid;
  for (const Steps least : pricing_.least) pricing_.bound += std::min<Steps>(0, least);
}

bool CutLp::enter_columns_that_gain() {
  const std::vector<int> gaining = gaining_columns(packing_, pricing_, lp_column_);
  for (const int j : gaining) enter(j);
  return !gaining.empty();
}

std::vector<Steps> CutLp::row_prices() const {
  std::vector<Steps> folded = prices_;
  for (int t = 0; t < packing_.trees(); ++t) {
    folded[index(packing_.root[index(t)])] -= std::min<Steps>(0, pricing_.least[index(t)]);
  }
  return folded;
}

std::vector<std::pair<int, double>> CutLp::point() const {
  constexpr double kZero = 1e-7;
  std::vector<std::pair<int, double>> point;
  const auto x = lp_.x();
  for (int k = 0; k < std::ssize(column_of_lp_); ++k) {
    if (x[index(k)] > kZero) point.emplace_back(column_of_lp_[index(k)], x[index(k)]);
  }
  return point;
}

}  // namespace mda
