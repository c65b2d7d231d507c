#include "algorithms/relaxation/normal_form.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kGridBits = 40;

void charge_rows(const AssociationProblem& problem, NormalForm& form) {
  form.charge.assign(index(problem.rows()), 0.0);
  form.column_of_charge.assign(index(problem.rows()), kNoColumn);
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    const int r = rows.front();
    if (rows.size() > 1 || problem.use(r) == RowUse::kAtMostOnce) continue;
    if (form.column_of_charge[index(r)] != kNoColumn && form.charge[index(r)] <= problem.cost(j)) {
      continue;
    }
    form.charge[index(r)] = problem.cost(j);
    form.column_of_charge[index(r)] = j;
  }
  for (int r = 0; r < problem.rows(); ++r) {
    if (problem.use(r) == RowUse::kExactlyOnce && form.column_of_charge[index(r)] == kNoColumn) {
      throw std::invalid_argument("row " + std::to_string(r) + " has no column of its own");
    }
  }
}

/// A column that gains something, with its gain in steps of the grid.
struct Gain {
  int column;
  std::int64_t steps;
  std::uint64_t hash = 0;
};

std::vector<Gain> gains_of(const AssociationProblem& problem, NormalForm& form) {
  std::vector<double> cost(index(problem.columns()));
  double largest = 0.0;
  for (int j = 0; j < problem.columns(); ++j) {
    cost[index(j)] = problem.cost(j);
    for (const int r : problem.rows_of(j)) cost[index(j)] -= form.charge[index(r)];
    largest = std::max(largest, -cost[index(j)]);
  }
  int exponent = 0;
  (void)std::frexp(largest, &exponent);
  form.unit = std::ldexp(1.0, exponent);
  std::vector<Gain> gains;
  for (int j = 0; j < problem.columns(); ++j) {
    if (cost[index(j)] >= 0.0) continue;
    const std::int64_t steps = std::llround(std::ldexp(cost[index(j)], kGridBits - exponent));
    if (steps < 0) gains.push_back({j, steps});
  }
  return gains;
}

std::uint64_t scramble(std::uint64_t z) {
  z = (z ^ (z >> 31)) * 0x7FB5D329728EA185ULL;
  z = (z ^ (z >> 27)) * 0x81DADEF4BC2DD44DULL;
  return z ^ (z >> 33);
}

/// Colour refinement: a column's hash is made of its cost and its rows' hashes, a row's of its
/// dimension and its columns' hashes.
std::vector<std::uint64_t> hash_rows(const AssociationProblem& problem, std::vector<Gain>& gains) {
  constexpr int kRounds = 4;
  std::vector<std::uint64_t> row_hash(index(problem.rows()));
  for (int r = 0; r < problem.rows(); ++r) {
    row_hash[index(r)] = scramble(static_cast<std::uint64_t>(problem.dimension(r)) + 1);
  }
  for (int round = 0; round < kRounds; ++round) {
    for (Gain& gain : gains) {
      gain.hash = scramble(static_cast<std::uint64_t>(gain.steps));
      for (const int r : problem.rows_of(gain.column)) gain.hash += scramble(row_hash[index(r)]);
      gain.hash = scramble(gain.hash);
    }
    std::vector<std::uint64_t> next = row_hash;
    for (const Gain& gain : gains) {
      for (const int r : problem.rows_of(gain.column)) next[index(r)] += gain.hash;
    }
    for (int r = 0; r < problem.rows(); ++r) row_hash[index(r)] = scramble(next[index(r)]);
  }
  return row_hash;
}

/// The problem's rows in their new order.
std::vector<int> order_rows(const AssociationProblem& problem,
                            const std::vector<std::uint64_t>& hash) {
  std::vector<int> order(hash.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::tuple(problem.dimension(a), hash[index(a)], a) <
           std::tuple(problem.dimension(b), hash[index(b)], b);
  });
  return order;
}

/// Sets of rows that are joined by columns.
class Components {
 public:
  Components(const AssociationProblem& problem, const std::vector<Gain>& gains)
      : parent_(index(problem.rows())), number_(parent_.size(), -1) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const Gain& gain : gains) {
      const auto rows = problem.rows_of(gain.column);
      for (const int r : rows.subspan(1)) parent_[index(root(r))] = root(rows.front());
    }
    for (const Gain& gain : gains) {
      int& number = number_[index(root(problem.rows_of(gain.column).front()))];
      if (number < 0) number = count_++;
    }
  }

  [[nodiscard]] int count() const { return count_; }
  /// -1 for rows without columns.
  [[nodiscard]] int of_row(int row) { return number_[index(root(row))]; }

 private:
  int root(int row) {
    while (parent_[index(row)] != row) {
      parent_[index(row)] = parent_[index(parent_[index(row)])];
      row = parent_[index(row)];
    }
    return row;
  }

  std::vector<int> parent_;
  std::vector<int> number_;
  int count_ = 0;
};

void split(const AssociationProblem& problem, const std::vector<Gain>& gains,
           const std::vector<int>& row_order, NormalForm& form) {
  Components components(problem, gains);
  form.components.resize(index(components.count()));
  std::vector<int> new_number(index(problem.rows()), -1);
  for (const int r : row_order) {
    if (components.of_row(r) < 0) continue;
    NormalComponent& part = form.components[index(components.of_row(r))];
    const bool next =
        !part.row.empty() && problem.dimension(part.row.back()) != problem.dimension(r);
    part.row_level.push_back(part.levels() - (part.row.empty() || next ? 0 : 1));
    new_number[index(r)] = part.rows();
    part.row.push_back(r);
  }
  for (const Gain& gain : gains) {
    const auto rows = problem.rows_of(gain.column);
    NormalComponent& part = form.components[index(components.of_row(rows.front()))];
    if (part.column_begin.empty()) part.column_begin.push_back(0);
    const auto first = static_cast<std::ptrdiff_t>(part.row_index.size());
    for (const int r : rows) part.row_index.push_back(new_number[index(r)]);
    std::sort(part.row_index.begin() + first, part.row_index.end());
    part.column_begin.push_back(static_cast<int>(part.row_index.size()));
    part.cost.push_back(std::ldexp(static_cast<double>(gain.steps), -kGridBits));
    part.column.push_back(gain.column);
  }
}

}  // namespace

std::vector<double> NormalForm::row_dual(const std::vector<double>& multiplier) const {
  std::vector<double> dual(multiplier.size());
  for (std::size_t r = 0; r < dual.size(); ++r) dual[r] = unit * multiplier[r] - charge[r];
  return dual;
}

std::vector<int> NormalForm::completed(const AssociationProblem& problem,
                                       std::vector<int> chosen) const {
  std::vector<char> used(index(problem.rows()), 0);
  for (const int j : chosen) {
    for (const int r : problem.rows_of(j)) used[index(r)] = 1;
  }
  for (int r = 0; r < problem.rows(); ++r) {
    if (used[index(r)] == 0 && column_of_charge[index(r)] != kNoColumn) {
      chosen.push_back(column_of_charge[index(r)]);
    }
  }
  return chosen;
}

double lagrangian_bound(const AssociationProblem& problem, std::span<const double> row_dual) {
  double bound = 0.0;
  for (const double u : row_dual) bound -= u;
  for (int j = 0; j < problem.columns(); ++j) {
    double price = problem.cost(j);
    for (const int r : problem.rows_of(j)) price += row_dual[index(r)];
    bound += std::min(0.0, price);
  }
  return bound;
}

NormalForm normal_form(const AssociationProblem& problem) {
  NormalForm form;
  charge_rows(problem, form);
  std::vector<Gain> gains = gains_of(problem, form);
  const std::vector<std::uint64_t> row_hash = hash_rows(problem, gains);
  std::sort(gains.begin(), gains.end(), [](const Gain& a, const Gain& b) {
    return std::tie(a.hash, a.steps, a.column) < std::tie(b.hash, b.steps, b.column);
  });
  split(problem, gains, order_rows(problem, row_hash), form);
  return form;
}

}  // namespace mda
