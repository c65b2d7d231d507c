#include "algorithms/tree/mht.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "algorithms/tree/clusters.h"
#include "algorithms/tree/ranked_assignment.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// The tracks that are alive after some scan.
struct Hypothesis {
  double cost = 0.0;       ///< their worth, nats
  std::vector<int> nodes;  ///< of one layer, ascending
};

/// What may become of a hypothesis in the next scan.
struct Extension {
  std::vector<int> nodes;  ///< per row of the assignment: a track, or, behind them, a birth
  std::size_t tracks;      ///< so many are tracks
  std::vector<int> plots;  ///< per column of the assignment: row of the problem
  RankedAssignments ranked;
};

/// One run.
class Run {
 public:
  Run(const AssociationProblem& problem, const MhtOptions& options, AssignmentSolver& solver,
      const Budget& budget)
      : problem_(problem),
        tree_(problem.views()->tree),
        options_(options),
        solver_(solver),
        budget_(budget),
        clusters_(clusters_of(problem)),
        column_of_plot_(index(problem.rows()), kNoColumn) {}

  Solution run() {
    std::vector<int> columns;
    for (int c = 0; c < clusters_.size() && !interrupted_; ++c) {
      for (const int leaf : best_leaves(clusters_.roots[index(c)])) {
        columns.push_back(tree_.column[index(leaf)]);
      }
    }
    add_leftovers(columns);
    Solution solution = selection_of(columns, problem_.columns(), Status::kFeasible);
    if (interrupted_) solution.stop = Stop::kDeadline;
    return solution;
  }

 private:
  [[nodiscard]] double worth(int node) const { return clusters_.worth[index(node)]; }

  /// Of one cluster, whose roots are given layer by layer.
  std::vector<int> best_leaves(const std::vector<std::vector<int>>& roots) {
    std::vector<Hypothesis> hypotheses = {hypothesis_of(roots.front())};
    for (std::size_t scan = 1; scan < roots.size(); ++scan) {
      hypotheses = extend(hypotheses, roots[scan]);
      if (interrupted_) return {};
    }
    double least = 0.0;
    std::vector<int> best;
    for (Hypothesis& hypothesis : hypotheses) {
      std::erase_if(hypothesis.nodes, [&](int leaf) { return worth(leaf) >= 0.0; });
      hypothesis = hypothesis_of(std::move(hypothesis.nodes));
      if (hypothesis.cost >= least) continue;
      least = hypothesis.cost;
      best = std::move(hypothesis.nodes);
    }
    return best;
  }

  [[nodiscard]] Hypothesis hypothesis_of(std::vector<int> nodes) const {
    std::sort(nodes.begin(), nodes.end());
    Hypothesis hypothesis{0.0, std::move(nodes)};
    for (const int node : hypothesis.nodes) hypothesis.cost += worth(node);
    return hypothesis;
  }

  /// The best extensions of all hypotheses by one scan, the cheapest first.
  std::vector<Hypothesis> extend(const std::vector<Hypothesis>& hypotheses,
                                 const std::vector<int>& births) {
    using Next = std::pair<double, std::size_t>;  // cost of an extension's next one
    std::priority_queue<Next, std::vector<Next>, std::greater<>> queue;
    std::vector<Extension> extensions;
    extensions.reserve(hypotheses.size());
    const auto enqueue = [&](std::size_t i) {
      const RankedAssignments& ranked = extensions[i].ranked;
      if (!ranked.empty()) queue.push({hypotheses[i].cost + ranked.next_cost(), i});
    };
    for (std::size_t i = 0; i < hypotheses.size() && !stopped(); ++i) {
      extensions.push_back(extension_of(hypotheses[i], births));
      enqueue(i);
    }
    std::vector<Hypothesis> extended;
    std::set<std::vector<int>> known;
    while (!queue.empty() && extended.size() < index(options_.hypotheses) && !stopped()) {
      const auto [cost, i] = queue.top();
      queue.pop();
      if (!extended.empty() && cost > extended.front().cost + options_.ratio_nats) break;
      Hypothesis next = extended_by(extensions[i], extensions[i].ranked.take());
      if (known.insert(next.nodes).second) extended.push_back(std::move(next));
      enqueue(i);
    }
    return extended;
  }

  bool stopped() {
    interrupted_ = interrupted_ || budget_.expired();
    return interrupted_;
  }

  Extension extension_of(const Hypothesis& hypothesis, const std::vector<int>& births) {
    SparseCosts costs;
    costs.row_begin.push_back(0);
    std::vector<int> plots;
    const auto add_pair = [&](int node, double cost) {
      int& column = column_of_plot_[index(tree_.row[index(node)])];
      if (column == kNoColumn) {
        column = static_cast<int>(plots.size());
        plots.push_back(tree_.row[index(node)]);
      }
      costs.column.push_back(column);
      costs.cost.push_back(cost);
    };
    const auto end_row = [&](double alone) {
      costs.row_begin.push_back(static_cast<int>(costs.column.size()));
      costs.alone.push_back(alone);
    };
    for (const int node : hypothesis.nodes) {
      double alone = -worth(node);
      for (int child = tree_.child_begin[index(node)]; child < tree_.child_end[index(node)];
           ++child) {
        const double step = worth(child) - worth(node);
        if (tree_.row[index(child)] == kNoRow) {
          alone = step;
        } else {
          add_pair(child, step);
        }
      }
      end_row(alone);
    }
    for (const int birth : births) {
      add_pair(birth, worth(birth));
      end_row(0.0);
    }
    costs.columns = static_cast<int>(plots.size());
    for (const int plot : plots) column_of_plot_[index(plot)] = kNoColumn;
    std::vector<int> nodes = hypothesis.nodes;
    nodes.insert(nodes.end(), births.begin(), births.end());
    return {std::move(nodes), hypothesis.nodes.size(), std::move(plots),
            RankedAssignments(std::move(costs), solver_)};
  }

  [[nodiscard]] Hypothesis extended_by(const Extension& extension,
                                       const RankedAssignment& assignment) const {
    std::vector<int> nodes;
    for (std::size_t i = 0; i < extension.nodes.size(); ++i) {
      const int column = assignment.column_of_row[i];
      const bool alone = column == Assignment::kAlone;
      int node = extension.nodes[i];
      if (i < extension.tracks) {
        node = child(node, alone ? kNoRow : extension.plots[index(column)]);
      } else if (alone) {
        node = kNoNode;
      }
      if (node != kNoNode) nodes.push_back(node);
    }
    return hypothesis_of(std::move(nodes));
  }

  /// The child that takes `row` (kNoRow: misses); kNoNode if there is none.
  [[nodiscard]] int child(int node, int row) const {
    for (int n = tree_.child_begin[index(node)]; n < tree_.child_end[index(node)]; ++n) {
      if (tree_.row[index(n)] == row) return n;
    }
    return kNoNode;
  }

  void add_leftovers(std::vector<int>& columns) const {
    std::vector<char> used(index(problem_.rows()), 0);
    for (const int j : columns) {
      for (const int r : problem_.rows_of(j)) used[index(r)] = 1;
    }
    for (int r = 0; r < problem_.rows(); ++r) {
      const int column = clusters_.leftover[index(r)].column;
      if (used[index(r)] == 0 && column != kNoColumn) columns.push_back(column);
    }
  }

  const AssociationProblem& problem_;
  const HypothesisTree& tree_;
  const MhtOptions& options_;
  AssignmentSolver& solver_;
  const Budget& budget_;
  Clusters clusters_;
  std::vector<int> column_of_plot_;  ///< per row: of the assignment being made, or kNoColumn
  bool interrupted_ = false;
};

class Mht final : public Associator {
 public:
  explicit Mht(const MhtOptions& options) : options_(options) {
    if (options.hypotheses < 1 || !(options.ratio_nats >= 0.0)) {
      throw std::invalid_argument("at least one hypothesis is kept, and the best one of all");
    }
  }

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .needs_tree = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    if (!shape.has_tree) return {false, "it needs the window's hypothesis tree"};
    return Associator::can_solve(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    return Run(problem, options_, solver_, budget).run();
  }

 private:
  MhtOptions options_;
  AssignmentSolver solver_;
};

}  // namespace

std::unique_ptr<Associator> make_mht(const MhtOptions& options) {
  return std::make_unique<Mht>(options);
}

}  // namespace mda
