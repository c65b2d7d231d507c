#include "algorithms/certified/branching.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mda {
namespace {

constexpr double kIntegral = 1e-6;
constexpr double kBest = 0.55;

bool uses(const Packing& packing, int column, int row) {
  const auto rows = packing.rows_of(column);
  return std::ranges::find(rows, row) != rows.end();
}

}  // namespace

std::vector<RowPair> halved_pairs(const Packing& packing,
                                  const std::vector<std::pair<int, double>>& point, int most) {
  std::map<RowPair, double> together;
  for (const auto& [column, value] : point) {
    if (value > 1.0 - kIntegral) continue;
    const auto rows = packing.rows_of(column);
    for (const int a : rows) {
      for (const int b : rows) {
        if (a < b) together[{a, b}] += value;
      }
    }
  }
  std::vector<std::pair<double, RowPair>> ranked;
  for (const auto& [rows, value] : together) {
    if (value < 1.0 - kIntegral) ranked.emplace_back(std::abs(value - kBest), rows);
  }
  const auto keep = std::min<std::ptrdiff_t>(most, std::ssize(ranked));
  std::ranges::partial_sort(ranked, ranked.begin() + keep);
  std::vector<RowPair> pairs;
  for (auto it = ranked.begin(); it != ranked.begin() + keep; ++it) pairs.push_back(it->second);
  return pairs;
}

Division division_by(const Packing& packing, const std::vector<int>& alive, RowPair rows) {
  Division division;
  division.rows = rows;
  for (const int j : alive) {
    const bool first = uses(packing, j, rows.first);
    const bool second = uses(packing, j, rows.second);
    if (first != second) division.with.push_back(j);
    if (first && second) division.without.push_back(j);
  }
  return division;
}

Division division_by_column(const Packing& packing, const std::vector<int>& alive,
                            const std::vector<std::pair<int, double>>& point) {
  std::vector<std::pair<double, int>> columns;
  for (const auto& [column, value] : point) columns.emplace_back(std::abs(value - kBest), column);
  std::ranges::sort(columns);
  for (const int j : alive) columns.emplace_back(1.0, j);
  for (const auto& [rank, column] : columns) {
    Division division;
    division.column = column;
    division.with = alive_rivals(packing, alive, column);
    division.without = {column};
    if (division.divides()) return division;
  }
  return {};
}

std::vector<int> alive_rivals(const Packing& packing, const std::vector<int>& alive, int column) {
  std::vector<int> rivals;
  for (const int j : alive) {
    const auto rows = packing.rows_of(j);
    const bool shares = std::ranges::any_of(rows, [&](int r) { return uses(packing, column, r); });
    if (shares && j != column) rivals.push_back(j);
  }
  return rivals;
}

}  // namespace mda
