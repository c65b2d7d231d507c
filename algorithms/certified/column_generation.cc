#include "algorithms/certified/column_generation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/backends/growing_lp.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

constexpr int kSmall = 4000;  // columns: up to here the whole LP is solved at once
constexpr int kFirstPerRow = 4;
constexpr int kMostPerTree = 3;  // new columns per round
constexpr std::size_t kMostPerRound = 600;

class ColumnGeneration {
 public:
  ColumnGeneration(const Packing& packing, std::vector<Steps> prices, const Budget& budget)
      : packing_(packing),
        budget_(budget),
        master_(packing.rows()),
        in_master_(packing.cost.size(), 0) {
    price(packing_, prices, pricing_);
    point_.bound = pricing_.bound;
    point_.prices = std::move(prices);
  }

  LpPoint run() {
    choose_first();
    std::vector<int> entering = std::move(first_);
    while (!entering.empty()) {
      for (const int j : entering) add_to_master(j);
      point_.outcome = master_.solve(GrowingLp::Method::kPrimal, budget_);
      point_.iterations = master_.iterations();
      if (point_.outcome != Outcome::kOptimal) return std::move(point_);
      ++point_.rounds;
      price_out();
      entering = columns_that_gain();
    }
    point_.outcome = Outcome::kOptimal;
    read_point();
    return std::move(point_);
  }

 private:
  /// The columns of least reduced cost of every row, or all.
  void choose_first() {
    if (packing_.columns() <= kSmall) {
      for (int j = 0; j < packing_.columns(); ++j) first_.push_back(j);
      return;
    }
    std::vector<std::array<int, kFirstPerRow>> best(index(packing_.rows()));
    for (auto& columns : best) columns.fill(-1);
    for (int j = 0; j < packing_.columns(); ++j) {
      for (const int r : packing_.rows_of(j)) {
        int candidate = j;
        for (int& place : best[index(r)]) {
          if (candidate < 0) break;
          if (place < 0 || pricing_.reduced[index(candidate)] < pricing_.reduced[index(place)]) {
            std::swap(candidate, place);
          }
        }
      }
    }
    std::vector<char> taken(packing_.cost.size(), 0);
    for (const auto& columns : best) {
      for (const int j : columns) {
        if (j < 0 || taken[index(j)] != 0) continue;
        taken[index(j)] = 1;
        first_.push_back(j);
      }
    }
  }

  void add_to_master(int column) {
    entries_.clear();
    for (const int r : packing_.rows_of(column)) entries_.push_back({r, 1.0});
    master_.add_column(static_cast<double>(packing_.cost[index(column)]) / kStepsPerLpUnit,
                       entries_);
    in_master_[index(column)] = 1;
    column_of_master_.push_back(column);
  }

  void price_out() {
    const std::vector<double> multipliers = master_.multipliers();
    std::vector<Steps> prices(multipliers.size());
    for (std::size_t r = 0; r < prices.size(); ++r) {
      prices[r] = std::llround(multipliers[r] * kStepsPerLpUnit);
    }
    price(packing_, prices, pricing_);
    if (pricing_.bound <= point_.bound) return;
    point_.bound = pricing_.bound;
    point_.prices = std::move(prices);
  }

  [[nodiscard]] std::vector<int> columns_that_gain() const {
    std::vector<int> gaining;
    const auto better = [&](int a, int b) {
      return pricing_.reduced[index(a)] < pricing_.reduced[index(b)];
    };
    for (int t = 0; t < packing_.trees(); ++t) {
      if (pricing_.least[index(t)] >= 0) continue;
      const auto first = static_cast<std::ptrdiff_t>(gaining.size());
      for (int j = packing_.tree_begin[index(t)]; j < packing_.tree_begin[index(t) + 1]; ++j) {
        if (pricing_.reduced[index(j)] >= 0 || in_master_[index(j)] != 0) continue;
        gaining.push_back(j);
      }
      if (std::ssize(gaining) - first <= kMostPerTree) continue;
      const auto keep = gaining.begin() + first + kMostPerTree;
      std::ranges::nth_element(gaining.begin() + first, keep, gaining.end(), better);
      gaining.erase(keep, gaining.end());
    }
    if (gaining.size() > kMostPerRound) {
      std::ranges::nth_element(gaining, gaining.begin() + kMostPerRound, better);
      gaining.resize(kMostPerRound);
    }
    return gaining;
  }

  void read_point() {
    const auto x = master_.x();
    constexpr double kZero = 1e-9;
    for (int k = 0; k < std::ssize(column_of_master_); ++k) {
      if (x[index(k)] > kZero) point_.x.emplace_back(column_of_master_[index(k)], x[index(k)]);
    }
    std::ranges::sort(point_.x);
  }

  const Packing& packing_;
  const Budget& budget_;
  GrowingLp master_;
  std::vector<char> in_master_;
  std::vector<int> column_of_master_;
  std::vector<GrowingLp::Entry> entries_;
  std::vector<int> first_;
  Pricing pricing_;
  LpPoint point_;
};

}  // namespace

LpPoint solve_by_columns(const Packing& packing, std::vector<Steps> prices, const Budget& budget) {
  return ColumnGeneration(packing, std::move(prices), budget).run();
}

}  // namespace mda
