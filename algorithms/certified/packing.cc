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
  int root;    ///< rank of a row
  Steps cost;
  std::size_t first_rank;
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
    number_rows();
    copy_columns();
  }

 private:
  [[nodiscard]] Steps steps(int column) const {
    return std::llround(problem_.cost(column) * scale_) * kGrid;
  }

  static constexpr int kSeveral = -2;
  static constexpr Steps kUnused = std::numeric_limits<Steps>::max();

  void find_gains() {
    for (int r = 0; r < problem_.rows() && has_charges_; ++r) {
      const int alone = window_.column_of_charge[index(r)];
      if (alone != kNone) window_.charge[index(r)] = steps(alone);
      window_.charged += window_.charge[index(r)];
    }
    gains_.reserve(index(problem_.columns()));
    cheapest_.assign(index(problem_.rows()), kUnused);
    for (int j = 0; j < problem_.columns(); ++j) {
      const auto rows = problem_.rows_of(j);
      Steps cost = steps(j);
      for (const int r : has_charges_ ? rows : std::span<const int>()) {
        cost -= window_.charge[index(r)];
      }
      if (cost >= 0) {
        window_.left_out += cost <= std::ssize(rows) * kGrid ? 1 : 0;
        continue;
      }
      gains_.push_back({j, kNone, cost, 0});
      for (const int r : rows) cheapest_[index(r)] = std::min(cheapest_[index(r)], cost);
    }
  }

  /// By dimension, then by the cheapest column: two rows of a dimension have no column in common.
  void order_rows() {
    std::vector<std::tuple<int, Steps, int>> order;
    for (int r = 0; r < problem_.rows(); ++r) {
      if (cheapest_[index(r)] == kUnused) continue;
      order.emplace_back(problem_.dimension(r), cheapest_[index(r)], r);
    }
    std::ranges::sort(order);
    for (const auto& [dimension, cost, r] : order) packing_.row_origin.push_back(r);
    rank_of_row_.assign(index(problem_.rows()), kNone);
    for (int i = 0; i < packing_.rows(); ++i)
      rank_of_row_[index(packing_.row_origin[index(i)])] = i;
  }

  /// A column's root is its first row in the new order.
  void find_roots() {
    only_root_.assign(index(packing_.rows()), kNone);
    columns_of_root_.assign(index(packing_.rows()), 0);
    ranks_.resize(index(problem_.nonzeros()));
    std::size_t entries = 0;
    for (Gain& gain : gains_) {
      const auto rows = problem_.rows_of(gain.column);
      const std::span<int> ranks(ranks_.data() + entries, rows.size());
      std::ranges::transform(rows, ranks.begin(), [&](int r) { return rank_of_row_[index(r)]; });
      const int root = *std::ranges::min_element(ranks);
      for (const int rank : ranks) {
        int& only = only_root_[index(rank)];
        only = only == kNone || only == root ? root : kSeveral;
      }
      gain.root = root;
      gain.first_rank = entries;
      entries += rows.size();
      ++columns_of_root_[index(root)];
    }
  }

  /// Those that are roots or have columns of two trees; the others go.
  void number_rows() {
    std::vector<int> kept;
    number_.assign(index(packing_.rows()), kNone);
    for (int i = 0; i < packing_.rows(); ++i) {
      if (only_root_[index(i)] != kSeveral && columns_of_root_[index(i)] == 0) continue;
      number_[index(i)] = static_cast<int>(kept.size());
      kept.push_back(packing_.row_origin[index(i)]);
    }
    packing_.row_origin = std::move(kept);
  }

  void copy_columns() {
    std::vector<int> next(number_.size(), 0);  // per root, the place of its next column
    int columns = 0;
    for (std::size_t i = 0; i < number_.size(); ++i) {
      if (columns_of_root_[i] == 0) continue;
      next[i] = columns;
      columns += columns_of_root_[i];
      packing_.root.push_back(number_[i]);
      packing_.tree_begin.push_back(columns);
    }
    std::vector<int> order(gains_.size());
    for (int g = 0; g < static_cast<int>(gains_.size()); ++g) {
      order[index(next[index(gains_[index(g)].root)]++)] = g;
    }
    packing_.cost.resize(gains_.size());
    packing_.origin.resize(gains_.size());
    packing_.begin.resize(gains_.size() + 1);
    packing_.row.resize(ranks_.size() + 1);  // what is left out is written, too, and lost
    int* entry = packing_.row.data();
    for (std::size_t j = 0; j < order.size(); ++j) {
      const Gain& gain = gains_[index(order[j])];
      packing_.cost[j] = gain.cost;
      packing_.origin[j] = gain.column;
      const auto rows = problem_.rows_of(gain.column).size();
      for (const int rank : std::span(ranks_.data() + gain.first_rank, rows)) {
        *entry = number_[index(rank)];
        entry += *entry != kNone ? 1 : 0;
      }
      packing_.begin[j + 1] = static_cast<int>(entry - packing_.row.data());
    }
    packing_.row.resize(index(packing_.begin.back()));
  }

  const AssociationProblem& problem_;
  WindowPacking& window_;
  Packing& packing_;
  bool has_charges_;
  double scale_;  ///< exact: costs times it are rounded as costs times 2^bits are
  std::vector<Gain> gains_;
  std::vector<Steps> cheapest_;       // per row of the problem, of its columns that gain
  std::vector<int> rank_of_row_;      // per row of the problem, its place in the order, or none
  std::vector<int> ranks_;            // of the rows of every gain
  std::vector<int> only_root_;        // per rank, the root of all its columns, or none, or several
  std::vector<int> columns_of_root_;  // per rank
  std::vector<int> number_;           // per rank, the number that the row gets, or none
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
