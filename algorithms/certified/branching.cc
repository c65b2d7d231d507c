#include "algorithms/certified/branching.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kIntegral = 1e-6;
constexpr double kBest = 0.55;
constexpr int kMostPairs = 8;  // to try for one that divides

bool uses(const Packing& packing, int column, int row) {
  const auto rows = packing.rows_of(column);
  return std::ranges::find(rows, row) != rows.end();
}

/// The pairs of rows that columns of the point use together, the best first.
std::vector<std::pair<int, int>> pairs_of(const Packing& packing,
                                          const std::vector<std::pair<int, double>>& point) {
  std::map<std::pair<int, int>, double> together;
  for (const auto& [column, value] : point) {
    if (value > 1.0 - kIntegral) continue;
    const auto rows = packing.rows_of(column);
    for (const int a : rows) {
      for (const int b : rows) {
        if (a < b) together[{a, b}] += value;
      }
    }
  }
  std::vector<std::pair<double, std::pair<int, int>>> ranked;
  for (const auto& [rows, value] : together) {
    if (value < 1.0 - kIntegral) ranked.emplace_back(std::abs(value - kBest), rows);
  }
  const auto keep = std::min<std::ptrdiff_t>(kMostPairs, std::ssize(ranked));
  std::ranges::partial_sort(ranked, ranked.begin() + keep);
  std::vector<std::pair<int, int>> pairs;
  for (auto it = ranked.begin(); it != ranked.begin() + keep; ++it) pairs.push_back(it->second);
  return pairs;
}

/// The columns that die on either side.
Division by_rows(const Packing& packing, std::span<const char> alive, std::pair<int, int> rows) {
  Division division;
  division.rows = rows;
  for (int j = 0; j < packing.columns(); ++j) {
    if (alive[index(j)] == 0) continue;
    const bool first = uses(packing, j, rows.first);
    const bool second = uses(packing, j, rows.second);
    if (first != second) division.with.push_back(j);
    if (first && second) division.without.push_back(j);
  }
  return division;
}

Division by_column(const Packing& packing, std::span<const char> alive, int column) {
  Division division;
  division.column = column;
  division.without = {column};
  for (int j = 0; j < packing.columns(); ++j) {
    if (alive[index(j)] == 0 || j == column) continue;
    const auto rows = packing.rows_of(j);
    if (std::ranges::any_of(rows, [&](int r) { return uses(packing, column, r); })) {
      division.with.push_back(j);
    }
  }
  return division;
}

}  // namespace

Division divide(const Packing& packing, std::span<const char> alive,
                const std::vector<std::pair<int, double>>& point) {
  for (const auto& rows : pairs_of(packing, point)) {
    Division division = by_rows(packing, alive, rows);
    if (!division.with.empty() && !division.without.empty()) return division;
  }
  std::vector<std::pair<double, int>> columns;
  for (const auto& [column, value] : point) columns.emplace_back(std::abs(value - kBest), column);
  std::ranges::sort(columns);
  for (int j = 0; j < packing.columns(); ++j) {
    if (alive[index(j)] != 0) columns.emplace_back(1.0, j);
  }
  for (const auto& [rank, column] : columns) {
    Division division = by_column(packing, alive, column);
    if (!division.with.empty()) return division;
  }
  return {};
}

}  // namespace mda
