#include "algorithms/testing/random_trees.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "algorithms/testing/draw.h"

namespace mda::testing {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

constexpr double kMiss = 1.5;
constexpr double kBirth = 1.0;

/// The random function behind the costs. A history is known by a key that every step changes, a
/// plot by its number in the plain order, counted over all scans.
class Likelihood {
 public:
  Likelihood(double history, std::uint64_t seed) : history_(history), seed_(seed) {}

  [[nodiscard]] double plot(std::uint64_t last, std::uint64_t history, int plot) const {
    return -9.0 + 14.0 * value(last, plot) + history_ * (value(history, plot) - 0.5);
  }
  [[nodiscard]] static std::uint64_t longer(std::uint64_t history, int plot) {
    return Draw(history * 31 + static_cast<std::uint64_t>(plot + 2)).bits();
  }

 private:
  [[nodiscard]] double value(std::uint64_t from, int plot) const {
    return Draw(Draw(from ^ (seed_ << 32)).bits() + static_cast<std::uint64_t>(plot)).unit();
  }

  double history_;
  std::uint64_t seed_;
};

/// One node while the trees grow.
struct Growing {
  int parent;
  int row;
  int track;
  double step;
  double cost;
  std::uint64_t last;     ///< key of the track or of the last plot
  std::uint64_t history;  ///< key of everything so far
  bool kept = false;
};

std::vector<int> plain_or_shuffled(int n, std::uint64_t order, std::uint64_t purpose) {
  if (order != 0) return Draw(order * 977 + purpose).permutation(n);
  std::vector<int> plain(index(n));
  std::iota(plain.begin(), plain.end(), 0);
  return plain;
}

class TreeMaker {
 public:
  TreeMaker(const TreeShape& shape, std::uint64_t seed, std::uint64_t order)
      : shape_(shape), likelihood_(shape.history, seed), order_(order) {}

  AssociationProblem make() {
    add_rows();
    grow();
    keep();
    auto views = std::make_shared<Views>();
    views->tree = flatten();
    AssociationProblem problem = add_columns(views->tree);
    if (shape_.must_go_on) views->tuple_cost = tuple_cost();
    problem.attach(std::move(views));
    return problem;
  }

 private:
  void add_rows() {
    const RowUse use = shape_.must_go_on ? RowUse::kExactlyOnce : RowUse::kAtMostOnce;
    track_of_row_ = plain_or_shuffled(shape_.tracks, order_, 1);
    for (int t = 0; t < shape_.tracks; ++t) builder_.add_row(0, use);
    plot_of_row_.assign(index(shape_.tracks), kNoRow);
    for (int k = 1; k <= shape_.scans; ++k) {
      for (const int m : plain_or_shuffled(shape_.plots, order_, 1 + static_cast<unsigned>(k))) {
        builder_.add_row(k, RowUse::kAtMostOnce);
        plot_of_row_.push_back((k - 1) * shape_.plots + m);
      }
    }
    builder_.set_dimensions(shape_.scans + 1);
  }

  [[nodiscard]] int first_row(int scan) const { return shape_.tracks + (scan - 1) * shape_.plots; }
  static std::uint64_t plot_key(int plot) { return 1000 + static_cast<std::uint64_t>(plot); }

  void grow() {
    layers_.resize(index(shape_.scans) + 1);
    for (int row = 0; row < shape_.tracks; ++row) {
      const auto key = static_cast<std::uint64_t>(track_of_row_[index(row)]) + 1;
      const double until_then = shape_.must_go_on ? 0.0 : -0.5 * static_cast<double>(key);
      layers_[0].push_back({kNoNode, row, row, until_then, until_then, key, key});
    }
    for (int k = 1; k <= shape_.scans; ++k) {
      const auto& before = layers_[index(k) - 1];
      for (int n = 0; n < static_cast<int>(before.size()); ++n)
        add_children(before[index(n)], n, k);
      if (!shape_.births) continue;
      for (int m = 0; m < shape_.plots; ++m) {
        const int row = first_row(k) + m;
        const std::uint64_t key = plot_key(plot_of_row_[index(row)]);
        layers_[index(k)].push_back({kNoNode, row, kNoRow, kBirth, kBirth, key, key});
      }
    }
  }

  void add_children(const Growing& node, int number, int scan) {
    auto& layer = layers_[index(scan)];
    for (int m = 0; m < shape_.plots; ++m) {
      const int row = first_row(scan) + m;
      const int plot = plot_of_row_[index(row)];
      const double step = likelihood_.plot(node.last, node.history, plot);
      if (step > shape_.gate_nats) continue;
      layer.push_back({number, row, node.track, step, node.cost + step, plot_key(plot),
                       Likelihood::longer(node.history, plot)});
    }
    layer.push_back({number, kNoRow, node.track, kMiss, node.cost + kMiss, node.last,
                     Likelihood::longer(node.history, kNoRow)});
  }

  /// Marks what leads to a column.
  void keep() {
    for (Growing& leaf : layers_.back()) {
      leaf.kept = (shape_.must_go_on && leaf.track != kNoRow) || leaf.cost < 0.0;
    }
    for (std::size_t k = layers_.size() - 1; k > 0; --k) {
      for (const Growing& node : layers_[k]) {
        if (node.kept && node.parent >= 0) layers_[k - 1][index(node.parent)].kept = true;
      }
    }
  }

  HypothesisTree flatten() {
    HypothesisTree tree;
    std::vector<int> number_before;
    for (const auto& layer : layers_) {
      tree.layer_begin.push_back(tree.nodes());
      std::vector<int> number(layer.size(), kNoNode);
      for (std::size_t n = 0; n < layer.size(); ++n) {
        if (!layer[n].kept) continue;
        number[n] = tree.nodes();
        const int parent = layer[n].parent;
        tree.parent.push_back(parent < 0 ? kNoNode : number_before[index(parent)]);
        tree.row.push_back(layer[n].row);
        tree.track.push_back(layer[n].track);
        tree.step.push_back(layer[n].step);
        tree.cost.push_back(layer[n].cost);
      }
      number_before = std::move(number);
    }
    tree.layer_begin.push_back(tree.nodes());
    tree.column.assign(index(tree.nodes()), kNoColumn);
    index_children(tree);
    return tree;
  }

  AssociationProblem add_columns(HypothesisTree& tree) {
    const int first = tree.layer_begin[index(shape_.scans)];
    for (const int i : plain_or_shuffled(tree.nodes() - first, order_, 99)) {
      std::vector<int> rows;
      for (int n = first + i; n != kNoNode; n = tree.parent[index(n)]) {
        if (tree.row[index(n)] != kNoRow) rows.push_back(tree.row[index(n)]);
      }
      tree.column[index(first + i)] = builder_.add_column(tree.cost[index(first + i)], rows);
    }
    return builder_.build();
  }

  [[nodiscard]] TupleCost tuple_cost() const {
    return [likelihood = likelihood_, tracks = track_of_row_,
            plots = plot_of_row_](const Tuple& tuple) {
      std::uint64_t last = static_cast<std::uint64_t>(tracks[index(tuple.track)]) + 1;
      std::uint64_t history = last;
      double cost = 0.0;
      for (const int row : tuple.rows) {
        const int plot = row == kNoRow ? kNoRow : plots[index(row)];
        cost += row == kNoRow ? kMiss : likelihood.plot(last, history, plot);
        if (row != kNoRow) last = plot_key(plot);
        history = Likelihood::longer(history, plot);
      }
      return cost;
    };
  }

  TreeShape shape_;
  Likelihood likelihood_;
  std::uint64_t order_;
  ProblemBuilder builder_;
  std::vector<int> track_of_row_;
  std::vector<int> plot_of_row_;
  std::vector<std::vector<Growing>> layers_;
};

}  // namespace

TreeShape random_tree_shape(std::uint64_t seed, bool births) {
  Draw draw(seed);
  TreeShape shape;
  shape.scans = 1 + draw.below(4);
  shape.tracks = 1 + draw.below(4);
  shape.plots = 1 + draw.below((14 - shape.tracks) / shape.scans);
  shape.plots = std::min(shape.plots, 4);
  shape.gate_nats = -2.0 + 6.0 * draw.unit();
  shape.history = draw.chance(0.3) ? 0.0 : 4.0 * draw.unit();
  shape.births = births && draw.chance(0.7);
  shape.must_go_on = !births;
  return shape;
}

AssociationProblem random_tree_problem(const TreeShape& shape, std::uint64_t seed,
                                       std::uint64_t order) {
  return TreeMaker(shape, seed, order).make();
}

}  // namespace mda::testing
