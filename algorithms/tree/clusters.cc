#include "algorithms/tree/clusters.h"

#include <algorithm>
#include <limits>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

std::vector<Leftover> leftovers(const AssociationProblem& problem) {
  std::vector<Leftover> leftover(index(problem.rows()));
  for (int r = 0; r < problem.rows(); ++r) {
    if (problem.use(r) == RowUse::kAtMostOnce) continue;
    leftover[index(r)].cost = std::numeric_limits<double>::infinity();
  }
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    if (rows.size() > 1) continue;
    Leftover& row = leftover[index(rows.front())];
    if (problem.cost(j) < row.cost) row = {problem.cost(j), j};
  }
  return leftover;
}

std::vector<double> worths(const HypothesisTree& tree, const std::vector<Leftover>& leftover) {
  std::vector<double> worth(index(tree.nodes()));
  for (int n = 0; n < tree.nodes(); ++n) {
    const int parent = tree.parent[index(n)];
    const int row = tree.row[index(n)];
    worth[index(n)] = tree.step[index(n)];
    if (parent != kNoNode) worth[index(n)] += worth[index(parent)];
    if (row != kNoRow) worth[index(n)] -= leftover[index(row)].cost;
  }
  return worth;
}

std::vector<double> promises(const HypothesisTree& tree, const std::vector<double>& worth) {
  std::vector<double> promise = worth;
  for (int n = tree.nodes() - 1; n >= 0; --n) {
    const int begin = tree.child_begin[index(n)];
    const int end = tree.child_end[index(n)];
    if (begin == end) continue;
    promise[index(n)] = *std::min_element(promise.begin() + begin, promise.begin() + end);
  }
  return promise;
}

}  // namespace

Clusters clusters_of(const AssociationProblem& problem) {
  const HypothesisTree& tree = problem.views()->tree;
  Clusters clusters;
  clusters.leftover = leftovers(problem);
  clusters.worth = worths(tree, clusters.leftover);
  clusters.promise = promises(tree, clusters.worth);
  if (problem.columns() == 0) return clusters;
  const auto layers = index(tree.scans()) + 1;
  clusters.roots.assign(index(problem.shape().components), std::vector<std::vector<int>>(layers));
  std::vector<int> cluster(index(tree.nodes()));
  for (int n = tree.nodes() - 1; n >= 0; --n) {
    const int column = tree.column[index(n)];
    cluster[index(n)] = column != kNoColumn ? problem.component_of_column()[index(column)]
                                            : cluster[index(tree.child_begin[index(n)])];
  }
  for (std::size_t layer = 0; layer < layers; ++layer) {
    for (int n = tree.layer_begin[layer]; n < tree.layer_begin[layer + 1]; ++n) {
      if (tree.parent[index(n)] != kNoNode) continue;
      clusters.roots[index(cluster[index(n)])][layer].push_back(n);
    }
  }
  return clusters;
}

}  // namespace mda
