#include "algorithms/certified/column_generation.h"

#include <algorithm>
#include <cmath>

#include "algorithms/backends/growing_lp.h"
#include "algorithms/certified/first_columns.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

class ColumnGeneration {
 public:
  ColumnGeneration(const Packing& packing, std::vector<Steps> prices, const Budget& budget)
      : packing_(packing),
        budget_(budget),
        master_(packing.rows()),
        in_master_(packing.cost.size(), -1) {
    price(packing_, prices, pricing_);
    point_.bound = pricing_.bound;
    point_.prices = std::move(prices);
  }

  LpPoint run() {
    std::vector<int> entering = first_columns(packing_, pricing_.reduced);
    while (!entering.empty()) {
      for (const int j : entering) add_to_master(j);
      point_.outcome = master_.solve(GrowingLp::Method::kPrimal, budget_);
      point_.iterations = master_.iterations();
      if (point_.outcome != Outcome::kOptimal) return std::move(point_);
      ++point_.rounds;
      price_out();
      entering = gaining_columns(packing_, pricing_, in_master_);
    }
    point_.outcome = Outcome::kOptimal;
    read_point();
    return std::move(point_);
  }

 private:
  void add_to_master(int column) {
    entries_.clear();
    for (const int r : packing_.rows_of(column)) entries_.push_back({r, 1.0});
    master_.add_column(static_cast<double>(packing_.cost[index(column)]) / kStepsPerLpUnit,
                       entries_);
    in_master_[index(column)] = static_cast<int>(column_of_master_.size());
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
  std::vector<int> in_master_;  // per column, its number there, or -1
  std::vector<int> column_of_master_;
  std::vector<GrowingLp::Entry> entries_;
  Pricing pricing_;
  LpPoint point_;
};

}  // namespace

std::vector<int> columns_by_value(std::vector<std::pair<int, double>> x) {
  std::ranges::stable_sort(x, std::greater<>{}, &std::pair<int, double>::second);
  std::vector<int> columns;
  columns.reserve(x.size());
  for (const auto& [column, value] : x) columns.push_back(column);
  return columns;
}

LpPoint solve_by_columns(const Packing& packing, std::vector<Steps> prices, const Budget& budget) {
  return ColumnGeneration(packing, std::move(prices), budget).run();
}

}  // namespace mda
