#include "algorithms/certified/packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "algorithms/api/certificate.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kCostBits = 34;
constexpr int kMostBits = 48;  // of any cost that is not left out, and of all charges together
constexpr int kNone = -1;

constexpr int kSeveral = -2;
constexpr Steps kUnused = std::numeric_limits<Steps>::max();

/// The finest with which `value` counts less than 2^`most` units.
int bits_for(double value, int most) {
  if (value == 0.0) return kFinestBits;
  int exponent = 0;
  (void)std::frexp(value, &exponent);
  return std::min(kFinestBits, most - exponent);
}

Steps steps_of(double cost, double scale) { return std::llrint(cost * scale) * kGrid; }

}  // namespace

Steps cost_of(const Packing& packing, std::span<const int> columns) {
  Steps cost = 0;
  for (const int j : columns) cost += packing.cost[index(j)];
  return cost;
}

std::vector<int> origins_of(const Packing& packing, std::span<const int> columns) {
  std::vector<int> origins;
  origins.reserve(columns.size());
  for (const int j : columns) origins.push_back(packing.origin[index(j)]);
  return origins;
}

double WindowPacking::nats(Steps steps) const {
  return std::ldexp(static_cast<double>(steps) / static_cast<double>(kGrid), -bits);
}

double WindowPacking::bound_nats(Steps bound) const {
  int used = packing.trees() + left_out;  // a choice has at most one column per tree or charged row
  for (std::size_t r = 0; r < charge.size(); ++r) {
    used += column_of_charge[r] == kNone ? 0 : 1;
  }
  return nats(bound + charged) - std::ldexp(0.5 * used, -bits);
}

std::vector<int> WindowPacking::completed(const AssociationProblem& problem,
                                          std::span<const int> chosen) const {
  std::vector<int> columns(chosen.begin(), chosen.end());
  std::vector<char> used(charge.size(), 0);
  for (const int j : chosen) {
    for (const int r : problem.rows_of(j)) used[index(r)] = 1;
  }
  for (std::size_t r = 0; r < charge.size(); ++r) {
    if (used[r] == 0 && column_of_charge[r] != kNone) columns.push_back(column_of_charge[r]);
  }
  return columns;
}

std::vector<double> WindowPacking::row_dual(std::span<const Steps> price) const {
  std::vector<double> dual(charge.size());
  for (std::size_t r = 0; r < charge.size(); ++r) dual[r] = nats(-charge[r]);
  for (int r = 0; r < packing.rows(); ++r) {
    dual[index(packing.row_origin[index(r)])] += nats(price[index(r)]);
  }
  return dual;
}

Status status_of(const AssociationProblem& problem, std::span<const int> choice,
                 double lower_bound) {
  double cost = 0.0;
  for (const int j : choice) cost += problem.cost(j);
  return cost - lower_bound <= cost_tolerance(cost) ? Status::kOptimal : Status::kFeasible;
}

/// Decides on rows and their order, then copies the columns tree by tree.
const WindowPacking& Packer::pack(const AssociationProblem& problem) {
  find_charges(problem);
  choose_bits(problem);
  charge(problem);
  find_gains(problem);
  order_rows(problem);
  number_rows_and_trees();
  copy_columns(problem);
  return window_;
}

/// The cheapest column alone of every exactly-once row.
void Packer::find_charges(const AssociationProblem& problem) {
  window_.charge.assign(index(problem.rows()), 0);
  window_.column_of_charge.assign(index(problem.rows()), kNone);
  if (!problem.shape().has_exactly_once_rows) return;
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    if (rows.size() > 1 || problem.use(rows[0]) == RowUse::kAtMostOnce) continue;
    int& best = window_.column_of_charge[index(rows[0])];
    if (best == kNone || problem.cost(j) < problem.cost(best)) best = j;
  }
}

/// What choosing the column saves, before rounding: its cost against that of the columns alone.
double Packer::gain_of(const AssociationProblem& problem, int column) const {
  double gain = -problem.cost(column);
  if (!problem.shape().has_exactly_once_rows) return gain;
  for (const int r : problem.rows_of(column)) {
    const int alone = window_.column_of_charge[index(r)];
    if (alone != kNone) gain += problem.cost(alone);
  }
  return gain;
}

/// WindowPacking::bits. A column that gains nothing may cost what it likes.
void Packer::choose_bits(const AssociationProblem& problem) {
  double largest_gain = 0.0;
  double largest = 0.0;
  for (const int alone : window_.column_of_charge) {
    if (alone != kNone) largest += std::abs(problem.cost(alone));
  }
  for (int j = 0; j < problem.columns(); ++j) {
    const double gain = gain_of(problem, j);
    if (gain <= 0.0) continue;
    largest_gain = std::max(largest_gain, gain);
    largest = std::max(largest, std::abs(problem.cost(j)));
  }
  window_.bits = std::min(bits_for(largest_gain, kCostBits), bits_for(largest, kMostBits));
}

void Packer::charge(const AssociationProblem& problem) {
  window_.charged = 0;
  if (!problem.shape().has_exactly_once_rows) return;
  const double scale = std::ldexp(1.0, window_.bits);
  for (std::size_t r = 0; r < window_.charge.size(); ++r) {
    const int alone = window_.column_of_charge[r];
    if (alone != kNone) window_.charge[r] = steps_of(problem.cost(alone), scale);
    window_.charged += window_.charge[r];
  }
}

void Packer::find_gains(const AssociationProblem& problem) {
  const bool has_charges = problem.shape().has_exactly_once_rows;
  // Exact: costs times it are rounded as costs times 2^bits are.
  const double scale = std::ldexp(1.0, window_.bits);
  window_.left_out = 0;
  gains_.clear();
  facts_.assign(index(problem.rows()), {kUnused, kNone, 0});
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    // Beyond what rounding could turn into a gain; its cost may be too large to be counted.
    const bool may_cost_much = problem.cost(j) > 0.0;
    if (may_cost_much && gain_of(problem, j) * scale < -2.0 * static_cast<double>(rows.size())) {
      continue;
    }
    Steps cost = steps_of(problem.cost(j), scale);
    for (const int r : has_charges ? rows : std::span<const int>()) {
      cost -= window_.charge[index(r)];
    }
    if (cost < 0) {
      add_gain(problem, j, cost);
    } else {
      window_.left_out += cost <= std::ssize(rows) * kGrid ? 1 : 0;
    }
  }
}

/// A column's root is its row of the first dimension.
void Packer::add_gain(const AssociationProblem& problem, int column, Steps cost) {
  const auto rows = problem.rows_of(column);
  int root = rows[0];
  for (const int r : rows) root = problem.dimension(r) < problem.dimension(root) ? r : root;
  for (const int r : rows) {
    RowFacts& facts = facts_[index(r)];
    facts.cheapest = std::min(facts.cheapest, cost);
    facts.only_root = facts.only_root == kNone || facts.only_root == root ? root : kSeveral;
  }
  ++facts_[index(root)].columns_as_root;
  gains_.push_back({column, root, cost});
}

/// By dimension, then by the cheapest column: two rows of a dimension have no column in common.
void Packer::order_rows(const AssociationProblem& problem) {
  ranked_.clear();
  for (int r = 0; r < problem.rows(); ++r) {
    if (facts_[index(r)].cheapest == kUnused) continue;
    ranked_.push_back({problem.dimension(r), r, facts_[index(r)].cheapest});
  }
  std::ranges::sort(ranked_, {}, [](const RankedRow& ranked) {
    return std::tuple(ranked.dimension, ranked.cheapest, ranked.row);
  });
}

/// Rows that are roots or have columns of two trees get numbers; the others go.
void Packer::number_rows_and_trees() {
  Packing& packing = window_.packing;
  packing.row_origin.clear();
  packing.root.clear();
  packing.tree_begin.assign(1, 0);
  number_.assign(facts_.size(), kNone);
  next_.resize(facts_.size());
  for (const RankedRow& ranked : ranked_) {
    const RowFacts& facts = facts_[index(ranked.row)];
    if (facts.only_root != kSeveral && facts.columns_as_root == 0) continue;
    number_[index(ranked.row)] = packing.rows();
    packing.row_origin.push_back(ranked.row);
    if (facts.columns_as_root == 0) continue;
    next_[index(ranked.row)] = packing.tree_begin.back();
    packing.root.push_back(number_[index(ranked.row)]);
    packing.tree_begin.push_back(packing.tree_begin.back() + facts.columns_as_root);
  }
}

/// Tree by tree.
void Packer::copy_columns(const AssociationProblem& problem) {
  Packing& packing = window_.packing;
  order_.resize(gains_.size());
  for (std::size_t g = 0; g < gains_.size(); ++g) {
    order_[index(next_[index(gains_[g].root)]++)] = static_cast<int>(g);
  }
  packing.cost.resize(gains_.size());
  packing.origin.resize(gains_.size());
  packing.begin.resize(gains_.size() + 1);
  packing.row.resize(index(problem.nonzeros()) + 1);  // what is left out is written, too, and lost
  int* entry = packing.row.data();
  for (std::size_t j = 0; j < order_.size(); ++j) {
    const Gain& gain = gains_[index(order_[j])];
    packing.cost[j] = gain.cost;
    packing.origin[j] = gain.column;
    for (const int r : problem.rows_of(gain.column)) {
      *entry = number_[index(r)];
      entry += *entry != kNone ? 1 : 0;
    }
    packing.begin[j + 1] = static_cast<int>(entry - packing.row.data());
  }
  packing.row.resize(index(packing.begin.back()));
}

WindowPacking pack(const AssociationProblem& problem) { return Packer().pack(problem); }

}  // namespace mda
