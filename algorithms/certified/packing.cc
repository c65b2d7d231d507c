#include "algorithms/certified/packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kCostBits = 32;
constexpr int kMostBits = 52;  // of any cost of the window, gain or not
constexpr int kNone = -1;

/// The cheapest column alone of every exactly-once row.
void find_charges(const AssociationProblem& problem, WindowPacking& window) {
  window.charge.assign(index(problem.rows()), 0);
  window.column_of_charge.assign(index(problem.rows()), kNone);
  if (!problem.shape().has_exactly_once_rows) return;
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    if (rows.size() > 1 || problem.use(rows[0]) == RowUse::kAtMostOnce) continue;
    int& best = window.column_of_charge[index(rows[0])];
    if (best == kNone || problem.cost(j) < problem.cost(best)) best = j;
  }
}

int exponent_of(double value) {
  int exponent = 0;
  (void)std::frexp(value, &exponent);
  return exponent;
}

/// WindowPacking::bits.
int choose_bits(const AssociationProblem& problem, const WindowPacking& window) {
  double largest_gain = 0.0;
  double largest = 0.0;
  const bool has_charges = problem.shape().has_exactly_once_rows;
  for (int j = 0; j < problem.columns(); ++j) {
    double gain = -problem.cost(j);
    for (const int r : has_charges ? problem.rows_of(j) : std::span<const int>()) {
      const int alone = window.column_of_charge[index(r)];
      if (alone != kNone) gain += problem.cost(alone);
    }
    largest_gain = std::max(largest_gain, gain);
    largest = std::max(largest, std::abs(problem.cost(j)));
  }
  return std::min(kCostBits - exponent_of(largest_gain), kMostBits - exponent_of(largest));
}

struct Gain {
  int column;  ///< of the problem
  int root;    ///< of the packing
  Steps cost;
};

/// Decides on rows and their order, then copies the columns tree by tree.
class Builder {
 public:
  Builder(const AssociationProblem& problem, WindowPacking& window)
      : problem_(problem),
        window_(window),
        packing_(window.packing),
        has_charges_(problem.shape().has_exactly_once_rows),
        scale_(std::ldexp(1.0, window.bits)) {}

  void build() {
    find_gains();
    order_rows();
    find_roots();
    copy_columns();
  }

 private:
  [[nodiscard]] Steps steps(int column) const {
    return std::llround(problem_.cost(column) * scale_) * kGrid;
  }

  void find_gains() {
    for (int r = 0; r < problem_.rows() && has_charges_; ++r) {
      const int alone = window_.column_of_charge[index(r)];
      if (alone != kNone) window_.charge[index(r)] = steps(alone);
      window_.charged += window_.charge[index(r)];
    }
    gains_.reserve(index(problem_.columns()));
    for (int j = 0; j < problem_.columns(); ++j) {
      Steps cost = steps(j);
      for (const int r : has_charges_ ? problem_.rows_of(j) : std::span<const int>()) {
        cost -= window_.charge[index(r)];
      }
      if (cost < 0) {
        gains_.push_back({j, kNone, cost});
      } else if (cost <= std::ssize(problem_.rows_of(j)) * kGrid) {
        ++window_.left_out;
      }
    }
  }

  /// By dimension, then by the cheapest column: two rows of a dimension have no column in common.
  void order_rows() {
    constexpr Steps kUnused = std::numeric_limits<Steps>::max();
    std::vector<Steps> cheapest(index(problem_.rows()), kUnused);
    for (const Gain& gain : gains_) {
      for (const int r : problem_.rows_of(gain.column)) {
        cheapest[index(r)] = std::min(cheapest[index(r)], gain.cost);
      }
    }
    std::vector<std::tuple<int, Steps, int>> order;
    for (int r = 0; r < problem_.rows(); ++r) {
      if (cheapest[index(r)] == kUnused) continue;
      order.emplace_back(problem_.dimension(r), cheapest[index(r)], r);
    }
    std::ranges::sort(order);
    for (const auto& [dimension, cost, r] : order) packing_.row_origin.push_back(r);
    row_number_.assign(index(problem_.rows()), kNone);
    for (int i = 0; i < packing_.rows(); ++i) row_number_[index(packing_.row_origin[index(i)])] = i;
  }

  /// A column's root is its first row in the new order. A row is kept if it is a root or has
  /// columns of two trees.
  void find_roots() {
    std::vector<int> only_root(index(packing_.rows()), kNone);
    constexpr int kSeveral = -2;
    columns_of_root_.assign(index(packing_.rows()), 0);
    for (Gain& gain : gains_) {
      const auto rows = problem_.rows_of(gain.column);
      gain.root = packing_.rows();
      for (const int r : rows) gain.root = std::min(gain.root, row_number_[index(r)]);
      ++columns_of_root_[index(gain.root)];
      for (const int r : rows) {
        int& only = only_root[index(row_number_[index(r)])];
        if (only == kNone) only = gain.root;
        if (only != gain.root) only = kSeveral;
      }
    }
    std::vector<int> kept;
    std::vector<int> kept_number(index(packing_.rows()), kNone);
    for (int i = 0; i < packing_.rows(); ++i) {
      const int r = packing_.row_origin[index(i)];
      const bool keep = only_root[index(i)] == kSeveral || columns_of_root_[index(i)] > 0;
      row_number_[index(r)] = keep ? static_cast<int>(kept.size()) : kNone;
      kept_number[index(i)] = row_number_[index(r)];
      if (keep) {
        columns_of_root_[kept.size()] = columns_of_root_[index(i)];
        kept.push_back(r);
      }
    }
    for (Gain& gain : gains_) gain.root = kept_number[index(gain.root)];
    columns_of_root_.resize(kept.size());
    packing_.row_origin = std::move(kept);
  }

  void copy_columns() {
    std::vector<int> next(columns_of_root_.size(), 0);  // per root, the place of its next column
    int columns = 0;
    for (int r = 0; r < packing_.rows(); ++r) {
      if (columns_of_root_[index(r)] == 0) continue;
      next[index(r)] = columns;
      columns += columns_of_root_[index(r)];
      packing_.root.push_back(r);
      packing_.tree_begin.push_back(columns);
    }
    std::vector<int> order(gains_.size());
    for (int g = 0; g < static_cast<int>(gains_.size()); ++g) {
      order[index(next[index(gains_[index(g)].root)]++)] = g;
    }
    packing_.cost.resize(gains_.size());
    packing_.origin.resize(gains_.size());
    packing_.begin.resize(gains_.size() + 1);
    packing_.row.resize(index(problem_.nonzeros()));
    int entries = 0;
    for (std::size_t j = 0; j < order.size(); ++j) {
      const Gain& gain = gains_[index(order[j])];
      packing_.cost[j] = gain.cost;
      packing_.origin[j] = gain.column;
      for (const int r : problem_.rows_of(gain.column)) {
        if (row_number_[index(r)] != kNone) packing_.row[index(entries++)] = row_number_[index(r)];
      }
      packing_.begin[j + 1] = entries;
    }
    packing_.row.resize(index(entries));
  }

  const AssociationProblem& problem_;
  WindowPacking& window_;
  Packing& packing_;
  bool has_charges_;
  double scale_;  ///< exact: costs times it are rounded as costs times 2^bits are
  std::vector<Gain> gains_;
  std::vector<int> row_number_;
  std::vector<int> columns_of_root_;
};

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

WindowPacking pack(const AssociationProblem& problem) {
  WindowPacking window;
  find_charges(problem, window);
  window.bits = choose_bits(problem, window);
  Builder(problem, window).build();
  return window;
}

}  // namespace mda
