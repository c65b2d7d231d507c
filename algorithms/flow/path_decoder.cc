#include "algorithms/flow/path_decoder.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace

PathDecoder::PathDecoder(const AssociationProblem& problem)
    : problem_(problem),
      tree_(problem.views()->tree),
      root_of_row_(index(problem.rows()), kNoNode) {
  for (int k = 0; k <= tree_.scans(); ++k) {
    // Births come last in their layer.
    for (int n = tree_.layer_begin[index(k) + 1] - 1;
         n >= tree_.layer_begin[index(k)] && tree_.parent[index(n)] == kNoNode; --n) {
      root_of_row_[index(tree_.row[index(n)])] = n;
    }
  }
}

int PathDecoder::child(int node, int row) const {
  for (int c = tree_.child_begin[index(node)]; c < tree_.child_end[index(node)]; ++c) {
    if (tree_.row[index(c)] == row) return c;
  }
  return kNoNode;
}

int PathDecoder::leaf(int root, std::span<const int> rows, Steps steps) const {
  int node = root;
  for (std::size_t k = 0; k < rows.size() && node != kNoNode; ++k) {
    const int next = child(node, rows[k]);
    node = next == kNoNode && steps == Steps::kRepaired ? child(node, kNoRow) : next;
  }
  return node;
}

void PathDecoder::take(int leaf) { chosen_.push_back(tree_.column[index(leaf)]); }

void PathDecoder::follow(const Tuple& tuple) {
  const int root = root_of_row_[index(tuple.track)];
  if (const int end = leaf(root, tuple.rows, Steps::kAsTheyAre); end != kNoNode) return take(end);
  ++off_column_paths_;
  const TupleCost& cost = problem_.views()->tuple_cost;
  if (cost && std::isfinite(cost(tuple))) {
    tuples_.push_back(tuple);
  } else if (const int end = leaf(root, tuple.rows, Steps::kRepaired); end != kNoNode) {
    take(end);
  } else {
    coast(tuple.track);
  }
}

int PathDecoder::coasting_leaf(int track) const {
  const bool must_go_on = problem_.use(track) == RowUse::kExactlyOnce;
  const std::vector<int> missed(index(tree_.scans()), kNoRow);
  const int end = leaf(root_of_row_[index(track)], missed, Steps::kAsTheyAre);
  if (end == kNoNode && must_go_on) {
    throw std::runtime_error("the track of row " + std::to_string(track) +
                             " must go on, but the tree lets it miss no scan");
  }
  return must_go_on || (end != kNoNode && tree_.cost[index(end)] < 0.0) ? end : kNoNode;
}

double PathDecoder::coasting_cost(int track) const {
  const int end = coasting_leaf(track);
  return end == kNoNode ? 0.0 : tree_.cost[index(end)];
}

void PathDecoder::coast(int track) {
  if (const int end = coasting_leaf(track); end != kNoNode) take(end);
}

void PathDecoder::begin(std::span<const int> rows) {
  const auto first = std::find_if(rows.begin(), rows.end(), [](int row) { return row != kNoRow; });
  const int root = root_of_row_[index(*first)];
  const std::span<const int> rest(first + 1, rows.end());
  int end = leaf(root, rest, Steps::kAsTheyAre);
  if (end == kNoNode) {
    ++off_column_paths_;
    end = leaf(root, rest, Steps::kRepaired);
  }
  if (end != kNoNode) take(end);
}

Solution PathDecoder::answer() const {
  Solution solution = selection_of(chosen_, problem_.columns(), Status::kFeasible);
  solution.tuples = tuples_;
  solution.stats.off_column_paths = off_column_paths_;
  return solution;
}

}  // namespace mda
