#include "algorithms/adapters/scan_by_scan.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "algorithms/api/one_scan.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// A partial track that the walk has chosen.
struct Live {
  int node;
  double rest;  ///< what the rows on its path cost without it
};

/// One walk through one tree.
class Walk {
 public:
  explicit Walk(const AssociationProblem& problem)
      : problem_(problem), tree_(problem.views()->tree), rests_(rests_of(problem)) {
    for (int n = tree_.layer_begin[0]; n < tree_.layer_begin[1]; ++n) add(n, 0.0);
  }

  [[nodiscard]] int scans() const { return tree_.scans(); }

  /// Rows 0.. are the live tracks, then come the plots of the scan that are in some child's path.
  [[nodiscard]] AssociationProblem scan_problem(int scan) {
    ProblemBuilder builder;
    builder.set_dimensions(2);
    for (std::size_t i = 0; i < live_.size(); ++i) builder.add_row(0, RowUse::kAtMostOnce);
    row_of_plot_.assign(index(problem_.rows()), kNoRow);
    child_of_column_.clear();
    for (int i = 0; i < static_cast<int>(live_.size()); ++i) add_pairs(i, scan, builder);
    return builder.build();
  }

  void advance(int scan, std::span<const double> x) {
    std::vector<int> chosen(live_.size(), kNoNode);
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (x[j] > 0.5) chosen[index(child_of_column_[j].first)] = child_of_column_[j].second;
    }
    std::vector<char> taken(index(problem_.rows()), 0);
    const std::vector<Live> before = std::exchange(live_, {});
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (chosen[i] == kNoNode) chosen[i] = child_without_plot(before[i].node);
      if (chosen[i] == kNoNode) continue;
      const int row = tree_.row[index(chosen[i])];
      if (row != kNoRow) taken[index(row)] = 1;
      add(chosen[i], before[i].rest);
    }
    add_births(scan, taken);
  }

  [[nodiscard]] Solution answer() const {
    std::vector<char> used(index(problem_.rows()), 0);
    std::vector<int> columns;
    for (const Live& live : live_) {
      if (tree_.cost[index(live.node)] > live.rest) continue;
      const int column = tree_.column[index(live.node)];
      columns.push_back(column);
      for (const int r : problem_.rows_of(column)) used[index(r)] = 1;
    }
    for (int r = 0; r < problem_.rows(); ++r) {
      if (used[index(r)] != 0 || rests_[index(r)].column == kNoColumn) continue;
      columns.push_back(rests_[index(r)].column);
    }
    return selection_of(columns, problem_.columns(), Status::kFeasible);
  }

 private:
  void add(int node, double rest_before) {
    const int row = tree_.row[index(node)];
    live_.push_back({node, rest_before + (row == kNoRow ? 0.0 : rests_[index(row)].cost)});
  }

  [[nodiscard]] int child_without_plot(int node) const {
    for (int c = tree_.child_begin[index(node)]; c < tree_.child_end[index(node)]; ++c) {
      if (tree_.row[index(c)] == kNoRow) return c;
    }
    return kNoNode;
  }

  /// Nats that a live track adds to the cost when it gets no plot in this scan. In the last scan
  /// costs are final, so that being dropped competes with going on.
  [[nodiscard]] double step_without_plot(const Live& live, int scan) const {
    const double dropped = live.rest - tree_.cost[index(live.node)];
    const int child = child_without_plot(live.node);
    if (child == kNoNode) return dropped;
    const double step = tree_.step[index(child)];
    return scan == scans() ? std::min(step, dropped) : step;
  }

  void add_pairs(int track, int scan, ProblemBuilder& builder) {
    const Live& live = live_[index(track)];
    const double otherwise = step_without_plot(live, scan);
    for (int c = tree_.child_begin[index(live.node)]; c < tree_.child_end[index(live.node)]; ++c) {
      const int plot = tree_.row[index(c)];
      if (plot == kNoRow) continue;
      int& row = row_of_plot_[index(plot)];
      if (row == kNoRow) row = builder.add_row(1, RowUse::kAtMostOnce);
      builder.add_column(tree_.step[index(c)] - otherwise - rests_[index(plot)].cost,
                         std::vector{track, row});
      child_of_column_.emplace_back(track, c);
    }
  }

  /// The cheapest birth from every plot that is not taken.
  void add_births(int scan, const std::vector<char>& taken) {
    std::vector<int> birth(index(problem_.rows()), kNoNode);
    for (int n = tree_.layer_begin[index(scan)]; n < tree_.layer_begin[index(scan) + 1]; ++n) {
      if (tree_.parent[index(n)] != kNoNode) continue;
      const int row = tree_.row[index(n)];
      if (taken[index(row)] != 0) continue;
      int& best = birth[index(row)];
      if (best == kNoNode || tree_.cost[index(n)] < tree_.cost[index(best)]) best = n;
    }
    for (const int n : birth) {
      if (n != kNoNode) add(n, 0.0);
    }
  }

  const AssociationProblem& problem_;
  const HypothesisTree& tree_;
  std::vector<Rest> rests_;
  std::vector<Live> live_;
  std::vector<int> row_of_plot_;                      ///< in the scan's problem
  std::vector<std::pair<int, int>> child_of_column_;  ///< live track and node
};

Solution no_answer(Stop stop, std::string note) {
  Solution nothing;
  nothing.stop = stop;
  nothing.note = std::move(note);
  return nothing;
}

class ScanByScan final : public Associator {
 public:
  explicit ScanByScan(std::unique_ptr<Associator> inner) : inner_(std::move(inner)) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection,
            .randomized = inner_->traits().randomized,
            .needs_tree = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    if (!shape.has_tree) return {false, "needs the window's hypothesis tree"};
    return Associator::can_solve(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    Walk walk(problem);
    for (int scan = 1; scan <= walk.scans(); ++scan) {
      const AssociationProblem part = walk.scan_problem(scan);
      const Verdict verdict = inner_->can_solve(part.shape());
      if (!verdict.ok) return no_answer(Stop::kFinished, verdict.reason);
      const Solution solution = inner_->solve(part, budget);
      if (solution.status == Status::kNoAnswer) return no_answer(solution.stop, solution.note);
      if (solution.answer != Answer::kSelection) {
        throw std::logic_error("scan by scan needs an algorithm that selects columns");
      }
      walk.advance(scan, solution.x);
    }
    return walk.answer();
  }

 private:
  std::unique_ptr<Associator> inner_;
};

}  // namespace

std::unique_ptr<Associator> make_scan_by_scan(std::unique_ptr<Associator> inner) {
  return std::make_unique<ScanByScan>(std::move(inner));
}

}  // namespace mda
