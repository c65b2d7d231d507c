#include "algorithms/backends/assignment.h"

#include <algorithm>
#include <functional>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

const Assignment& AssignmentSolver::solve(const SparseCosts& costs) {
  reset(costs);
  result_.feasible = true;
  for (int row = 0; row < costs.rows(); ++row) {
    if (!insert(costs, row)) {
      result_.feasible = false;
      break;
    }
  }
  finish(costs);
  return result_;
}

void AssignmentSolver::reset(const SparseCosts& costs) {
  const auto columns = index(costs.columns);
  result_.column_of_row.assign(costs.alone.size(), Assignment::kAlone);
  result_.row_price.assign(costs.alone.size(), 0.0);
  result_.column_price.assign(columns, 0.0);
  row_of_column_.assign(columns, kFree);
  pair_cost_.assign(columns, 0.0);
  distance_.assign(columns, kInfinity);
  reached_from_.assign(columns, kFree);
  entry_cost_.assign(columns, 0.0);
  settled_.assign(columns, 0);
}

/// Dijkstra's search from `root` over alternating paths; it ends at a free column, or at a row on
/// the tree that is cheapest when left alone. Columns in pairs have tight prices, so that stepping
/// from a column back to its row costs minus (cost + price) of the pair.
bool AssignmentSolver::insert(const SparseCosts& costs, int root) {
  best_alone_ = kInfinity;
  relax(costs, root, 0.0);
  bool found = false;
  while (!found) {
    const int column = nearest_column();
    const double near = column == kFree ? kInfinity : distance_[index(column)];
    if (best_alone_ < kInfinity && best_alone_ <= near) {
      raise_prices(best_alone_);
      const int given_up = result_.column_of_row[index(best_alone_row_)];
      result_.column_of_row[index(best_alone_row_)] = Assignment::kAlone;
      augment(given_up);
      found = true;
    } else if (column == kFree) {
      break;
    } else if (row_of_column_[index(column)] == kFree) {
      raise_prices(near);
      augment(column);
      found = true;
    } else {
      settled_[index(column)] = 1;
      settled_columns_.push_back(column);
      relax(costs, row_of_column_[index(column)],
            near - (pair_cost_[index(column)] + result_.column_price[index(column)]));
    }
  }
  forget_tree();
  return found;
}

void AssignmentSolver::relax(const SparseCosts& costs, int row, double offset) {
  const double alone = offset + costs.alone[index(row)];
  if (alone < best_alone_) {
    best_alone_ = alone;
    best_alone_row_ = row;
  }
  for (int e = costs.row_begin[index(row)]; e < costs.row_begin[index(row) + 1]; ++e) {
    const int column = costs.column[index(e)];
    if (settled_[index(column)] != 0) continue;
    const double distance = offset + costs.cost[index(e)] + result_.column_price[index(column)];
    if (!(distance < distance_[index(column)])) continue;
    if (distance_[index(column)] == kInfinity) touched_.push_back(column);
    distance_[index(column)] = distance;
    reached_from_[index(column)] = row;
    entry_cost_[index(column)] = costs.cost[index(e)];
    heap_.emplace_back(distance, column);
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>{});
  }
}

/// The unsettled column at the least distance, or kFree.
int AssignmentSolver::nearest_column() {
  while (!heap_.empty()) {
    const auto [distance, column] = heap_.front();
    if (settled_[index(column)] == 0 && distance == distance_[index(column)]) return column;
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>{});
    heap_.pop_back();
  }
  return kFree;
}

void AssignmentSolver::raise_prices(double distance) {
  for (const int column : settled_columns_) {
    result_.column_price[index(column)] += std::max(0.0, distance - distance_[index(column)]);
  }
}

/// Gives `column` to the row it was reached from, that row's old column to the row before it, and
/// so on up to the root.
void AssignmentSolver::augment(int column) {
  while (column != Assignment::kAlone) {
    const int row = reached_from_[index(column)];
    const int given_up = result_.column_of_row[index(row)];
    result_.column_of_row[index(row)] = column;
    row_of_column_[index(column)] = row;
    pair_cost_[index(column)] = entry_cost_[index(column)];
    column = given_up;
  }
}

void AssignmentSolver::forget_tree() {
  for (const int column : touched_) {
    distance_[index(column)] = kInfinity;
    settled_[index(column)] = 0;
  }
  touched_.clear();
  settled_columns_.clear();
  heap_.clear();
}

/// Row prices are the largest that the columns' prices allow: feasible without any rounding error.
void AssignmentSolver::finish(const SparseCosts& costs) {
  double cost = 0.0;
  for (int row = 0; row < costs.rows(); ++row) {
    double price = costs.alone[index(row)];
    for (int e = costs.row_begin[index(row)]; e < costs.row_begin[index(row) + 1]; ++e) {
      const double limit =
          costs.cost[index(e)] + result_.column_price[index(costs.column[index(e)])];
      price = std::min(price, limit);
    }
    result_.row_price[index(row)] = price;
    const int column = result_.column_of_row[index(row)];
    cost += column == Assignment::kAlone ? costs.alone[index(row)] : pair_cost_[index(column)];
  }
  result_.cost = result_.feasible ? cost : kInfinity;
}

}  // namespace mda
