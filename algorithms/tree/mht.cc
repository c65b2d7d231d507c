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

/// What a track that so far costs more than false alarms counts of its cost. Nothing would be the
/// truth, since it can be dropped, but then all that such tracks may do would tie.
constexpr double kTentativeShare = 0.1;

/// By what a track is ranked while it is alive, per node, nats.
std::vector<double> scores(const HypothesisTree& tree, const Clusters& clusters, bool look_ahead) {
  std::vector<double> score(index(tree.nodes()));
  for (int layer = 0; layer <= tree.scans(); ++layer) {
    const double share = look_ahead ? 1.0 / (tree.scans() - layer + 1.0) : 0.0;
    for (int n = tree.layer_begin[index(layer)]; n < tree.layer_begin[index(layer) + 1]; ++n) {
      const double worth = clusters.worth[index(n)];
      const double so_far = std::min(worth, kTentativeShare * worth);
      const double in_the_end = std::min(0.0, clusters.promise[index(n)]);
      score[index(n)] = (1.0 - share) * so_far + share * in_the_end;
    }
  }
  return score;
}

/// The tracks that are alive after some scan.
struct Hypothesis {
  double cost = 0.0;       ///< their scores, nats
  std::vector<int> nodes;  ///< of one layer, ascending
};

/// What may become of a hypothesis in the next scan.
struct Extension {
  std::vector<int> nodes;    ///< per row of the assignment
  std::vector<int> plots;    ///< per column of the assignment: row of the problem
  double cost_of_no_change;  ///< of the hypothesis and of every birth, nats
  RankedAssignments ranked;

  [[nodiscard]] double next_cost() const { return cost_of_no_change + ranked.next_cost(); }
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
        score_(scores(tree_, clusters_, options.look_ahead)),
        column_of_plot_(index(problem.rows()), kNoColumn),
        birth_score_(index(problem.rows()), 0.0) {
    for (const auto& roots : clusters_.roots) {
      for (std::size_t scan = 1; scan < roots.size(); ++scan) {
        for (const int birth : roots[scan]) birth_score_[index(row(birth))] = score(birth);
      }
    }
  }

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
  [[nodiscard]] int row(int node) const { return tree_.row[index(node)]; }
  [[nodiscard]] double worth(int node) const { return clusters_.worth[index(node)]; }
  [[nodiscard]] double score(int node) const { return score_[index(node)]; }

  /// Of one cluster, whose roots are given layer by layer.
  std::vector<int> best_leaves(const std::vector<std::vector<int>>& roots) {
    std::vector<Hypothesis> hypotheses = {hypothesis_of(roots.front())};
    for (std::size_t scan = 1; scan < roots.size(); ++scan) {
      hypotheses = extend(hypotheses, roots[scan]);
      if (interrupted_) return {};
    }
    // Of a leaf that is worth it, the score is the worth.
    Hypothesis best;
    for (Hypothesis& hypothesis : hypotheses) {
      std::erase_if(hypothesis.nodes, [&](int leaf) { return worth(leaf) >= 0.0; });
      hypothesis = hypothesis_of(std::move(hypothesis.nodes));
      if (hypothesis.cost < best.cost) best = std::move(hypothesis);
    }
    return best.nodes;
  }

  [[nodiscard]] Hypothesis hypothesis_of(std::vector<int> nodes) const {
    std::sort(nodes.begin(), nodes.end());
    Hypothesis hypothesis{0.0, std::move(nodes)};
    for (const int node : hypothesis.nodes) hypothesis.cost += score(node);
    return hypothesis;
  }

  /// The best extensions of all hypotheses by one scan, the cheapest first.
  std::vector<Hypothesis> extend(const std::vector<Hypothesis>& hypotheses,
                                 const std::vector<int>& births) {
    using Next = std::pair<double, std::size_t>;  // the cost of an extension's next assignment
    std::priority_queue<Next, std::vector<Next>, std::greater<>> queue;
    std::vector<Extension> extensions;
    extensions.reserve(hypotheses.size());
    const auto enqueue = [&](std::size_t i) {
      if (!extensions[i].ranked.empty()) queue.push({extensions[i].next_cost(), i});
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
      Hypothesis next = extended_by(extensions[i].ranked.take(), extensions[i], births);
      if (known.insert(next.nodes).second) extended.push_back(std::move(next));
      enqueue(i);
    }
    return extended;
  }

  bool stopped() {
    interrupted_ = interrupted_ || budget_.expired();
    return interrupted_;
  }

  /// The assignment of the tracks to the plots. A plot that a track takes starts no other, so the
  /// track pays for that birth back.
  Extension extension_of(const Hypothesis& hypothesis, const std::vector<int>& births) {
    SparseCosts costs;
    costs.row_begin.push_back(0);
    std::vector<int> plots;
    for (const int node : hypothesis.nodes) {
      double alone = -score(node);
      for (int n = tree_.child_begin[index(node)]; n < tree_.child_end[index(node)]; ++n) {
        const double step = score(n) - score(node);
        if (row(n) == kNoRow) {
          alone = step;
        } else {
          costs.column.push_back(column_of(row(n), plots));
          costs.cost.push_back(step - birth_score_[index(row(n))]);
        }
      }
      costs.row_begin.push_back(static_cast<int>(costs.column.size()));
      costs.alone.push_back(alone);
    }
    costs.columns = static_cast<int>(plots.size());
    for (const int plot : plots) column_of_plot_[index(plot)] = kNoColumn;
    double no_change = hypothesis.cost;
    for (const int birth : births) no_change += score(birth);
    return {hypothesis.nodes, std::move(plots), no_change,
            RankedAssignments(std::move(costs), solver_)};
  }

  /// Numbers the plots in the order in which they come.
  int column_of(int plot, std::vector<int>& plots) {
    int& column = column_of_plot_[index(plot)];
    if (column == kNoColumn) {
      column = static_cast<int>(plots.size());
      plots.push_back(plot);
    }
    return column;
  }

  [[nodiscard]] Hypothesis extended_by(const RankedAssignment& assignment,
                                       const Extension& extension,
                                       const std::vector<int>& births) const {
    std::vector<int> nodes;
    std::vector<char> taken(extension.plots.size(), 0);
    for (std::size_t i = 0; i < extension.nodes.size(); ++i) {
      const int column = assignment.column_of_row[i];
      const bool alone = column == Assignment::kAlone;
      if (!alone) taken[index(column)] = 1;
      const int next = child(extension.nodes[i], alone ? kNoRow : extension.plots[index(column)]);
      if (next != kNoNode) nodes.push_back(next);
    }
    for (const int birth : births) {
      const auto plot = std::find(extension.plots.begin(), extension.plots.end(), row(birth));
      const bool free = plot == extension.plots.end() ||
                        taken[static_cast<std::size_t>(plot - extension.plots.begin())] == 0;
      if (free) nodes.push_back(birth);
    }
    return hypothesis_of(std::move(nodes));
  }

  /// The child that takes the plot of `plot_row` (kNoRow: misses); kNoNode if there is none.
  [[nodiscard]] int child(int node, int plot_row) const {
    for (int n = tree_.child_begin[index(node)]; n < tree_.child_end[index(node)]; ++n) {
      if (row(n) == plot_row) return n;
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
  std::vector<double> score_;        ///< per node
  std::vector<int> column_of_plot_;  ///< per row: of the assignment being made, or kNoColumn
  std::vector<double> birth_score_;  ///< per row: of the track that begins with this plot, or 0
  bool interrupted_ = budget_.expired();
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
