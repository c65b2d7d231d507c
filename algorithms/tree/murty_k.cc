#include "algorithms/tree/murty_k.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// The choices of one component that contain `forced` and none of `forbidden`.
struct Part {
  int component = 0;
  std::vector<int> forced;
  std::vector<int> forbidden;
  bool more = false;  ///< only those that contain another column too; `forced` breaks no row
  Choice best;
  double increment = 0.0;  ///< cost of `best` minus that of the component's cheapest choice
};

struct ComesLater {
  bool operator()(const Part& a, const Part& b) const {
    return std::tie(a.increment, a.component, a.best) > std::tie(b.increment, b.component, b.best);
  }
};

/// A choice of some components.
struct Ranked {
  double increment = 0.0;
  Choice columns;
};

double cost_of(const AssociationProblem& problem, const Choice& choice) {
  double cost = 0.0;
  for (const int j : choice) cost += problem.cost(j);
  return cost;
}

Choice with(Choice choice, int column) {
  choice.insert(std::upper_bound(choice.begin(), choice.end(), column), column);
  return choice;
}

/// The `most` cheapest sums of one of `a` and one of `b`.
std::vector<Ranked> sums(const std::vector<Ranked>& a, const std::vector<Ranked>& b, int most) {
  std::vector<Ranked> all;
  all.reserve(a.size() * b.size());
  for (const Ranked& first : a) {
    for (const Ranked& second : b) {
      all.push_back({first.increment + second.increment, first.columns});
      all.back().columns.insert(all.back().columns.end(), second.columns.begin(),
                                second.columns.end());
    }
  }
  std::sort(all.begin(), all.end(), [](const Ranked& x, const Ranked& y) {
    return std::tie(x.increment, x.columns) < std::tie(y.increment, y.columns);
  });
  if (all.size() > index(most)) all.resize(index(most));
  return all;
}

/// One run.
class Ranking {
 public:
  Ranking(const AssociationProblem& problem, Associator& inner, const Budget& budget)
      : problem_(problem),
        inner_(inner),
        budget_(budget),
        components_(index(problem.shape().components)),
        number_of_row_(index(problem.rows()), kOpen) {
    for (int j = 0; j < problem.columns(); ++j) component_of(j).columns.push_back(j);
    std::vector<char> seen(index(problem.rows()), 0);
    for (int j = 0; j < problem.columns(); ++j) {
      for (const int r : problem.rows_of(j)) {
        if (problem.use(r) != RowUse::kExactlyOnce || seen[index(r)] != 0) continue;
        seen[index(r)] = 1;
        component_of(j).exactly_once_rows.push_back(r);
      }
    }
  }

  Solution run(int most) {
    Solution solution = inner_.solve(problem_, budget_);
    const Choice first = chosen(solution);
    if (solution.status == Status::kFeasible) solution.ranked = {first};
    if (solution.status != Status::kOptimal) return solution;
    split_first(first);
    int proven = 1;
    while (proven < most && !queue_.empty() && !interrupted_) {
      const Part part = queue_.top();
      queue_.pop();
      component(part).ranked.push_back({part.increment, part.best});
      ++proven;
      // Nothing is left to be taken after the last one.
      if (proven < most) split(part);
    }
    // A choice that is not in the lists changes a component by at least the last increment, and
    // every one in the lists so far makes a choice on its own.
    rank(interrupted_ ? proven : most, solution);
    return solution;
  }

 private:
  static constexpr int kOpen = -1;    ///< a row that no column of the part's problem has used yet
  static constexpr int kFilled = -2;  ///< a row of a forced column

  struct Component {
    std::vector<int> columns;
    std::vector<int> exactly_once_rows;
    double least_cost = 0.0;
    std::vector<Ranked> ranked;
  };

  Component& component_of(int column) {
    return components_[index(problem_.component_of_column()[index(column)])];
  }
  Component& component(const Part& part) { return components_[index(part.component)]; }

  static Choice chosen(const Solution& solution) {
    Choice choice;
    for (std::size_t j = 0; j < solution.x.size(); ++j) {
      if (solution.x[j] > 0.5) choice.push_back(static_cast<int>(j));
    }
    return choice;
  }

  void split_first(const Choice& first) {
    for (Component& part : components_) part.ranked.push_back({});
    for (const int j : first) component_of(j).ranked.front().columns.push_back(j);
    for (int c = 0; c < static_cast<int>(components_.size()) && !interrupted_; ++c) {
      Part all;
      all.component = c;
      all.best = component(all).ranked.front().columns;
      component(all).least_cost = cost_of(problem_, all.best);
      split(all);
    }
  }

  /// The part without its best choice, as parts.
  void split(const Part& part) {
    Part rest = part;
    for (const int j : part.best) {
      if (std::binary_search(part.forced.begin(), part.forced.end(), j)) continue;
      Part without = rest;
      without.forbidden.push_back(j);
      add(std::move(without));
      if (interrupted_) return;
      rest.forced = with(std::move(rest.forced), j);
    }
    rest.more = true;
    add(std::move(rest));
  }

  void add(Part part) {
    std::optional<Choice> best = part.more ? cheapest_addition(part) : optimum(part);
    if (!best.has_value()) return;
    part.best = std::move(*best);
    part.increment = cost_of(problem_, part.best) - component(part).least_cost;
    queue_.push(std::move(part));
  }

  /// `forced` was once the best choice of a part that contains this one, so no set of further
  /// columns makes it cheaper, and a single one is the best addition.
  std::optional<Choice> cheapest_addition(const Part& part) {
    fill_rows_of_forced(part);
    std::optional<int> cheapest;
    for (const int j : component(part).columns) {
      if (!is_open(part, j)) continue;
      if (!cheapest.has_value() || problem_.cost(j) < problem_.cost(*cheapest)) cheapest = j;
    }
    clear_rows(part);
    if (!cheapest.has_value()) return std::nullopt;
    return with(part.forced, *cheapest);
  }

  std::optional<Choice> optimum(const Part& part) {
    fill_rows_of_forced(part);
    builder_.clear();
    std::vector<int> open;
    for (const int j : component(part).columns) {
      if (!is_open(part, j)) continue;
      open.push_back(j);
      add_column(j);
    }
    const auto& must = component(part).exactly_once_rows;
    const bool can_be_filled = std::none_of(
        must.begin(), must.end(), [&](int r) { return number_of_row_[index(r)] == kOpen; });
    clear_rows(part);
    if (!can_be_filled) return std::nullopt;
    Choice best = part.forced;
    if (open.empty()) return best;
    const Solution solution = inner_.solve(builder_.build(), budget_);
    if (solution.stop != Stop::kFinished) interrupted_ = true;
    if (solution.status != Status::kOptimal) return std::nullopt;
    for (const int j : chosen(solution)) best.push_back(open[index(j)]);
    std::sort(best.begin(), best.end());
    return best;
  }

  void add_column(int column) {
    std::vector<int> rows;
    for (const int r : problem_.rows_of(column)) {
      int& number = number_of_row_[index(r)];
      if (number == kOpen) number = builder_.add_row(problem_.dimension(r), problem_.use(r));
      rows.push_back(number);
    }
    builder_.add_column(problem_.cost(column), rows);
  }

  void fill_rows_of_forced(const Part& part) {
    for (const int j : part.forced) {
      for (const int r : problem_.rows_of(j)) number_of_row_[index(r)] = kFilled;
    }
  }

  [[nodiscard]] bool is_open(const Part& part, int column) const {
    const auto rows = problem_.rows_of(column);
    return std::none_of(rows.begin(), rows.end(),
                        [&](int r) { return number_of_row_[index(r)] == kFilled; }) &&
           std::find(part.forbidden.begin(), part.forbidden.end(), column) == part.forbidden.end();
  }

  void clear_rows(const Part& part) {
    for (const int j : component(part).columns) {
      for (const int r : problem_.rows_of(j)) number_of_row_[index(r)] = kOpen;
    }
  }

  /// Adds the components' lists up.
  void rank(int most, Solution& solution) const {
    std::vector<Ranked> all = {{}};
    for (const Component& part : components_) all = sums(all, part.ranked, most);
    for (Ranked& ranked : all) {
      std::sort(ranked.columns.begin(), ranked.columns.end());
      ranked.increment = cost_of(problem_, ranked.columns);
    }
    std::sort(all.begin(), all.end(), [](const Ranked& a, const Ranked& b) {
      return std::tie(a.increment, a.columns) < std::tie(b.increment, b.columns);
    });
    for (Ranked& ranked : all) solution.ranked.push_back(std::move(ranked.columns));
    solution.x = selection_of(solution.ranked.front(), problem_.columns(), Status::kOptimal).x;
    if (!interrupted_) return;
    solution.status = Status::kFeasible;
    solution.stop = Stop::kDeadline;
  }

  const AssociationProblem& problem_;
  Associator& inner_;
  const Budget& budget_;
  std::vector<Component> components_;
  std::priority_queue<Part, std::vector<Part>, ComesLater> queue_;
  bool interrupted_ = false;
  ProblemBuilder builder_;
  std::vector<int> number_of_row_;  ///< in the part's problem, or kOpen, or kFilled
};

class MurtyK final : public Associator {
 public:
  MurtyK(const MurtyOptions& options, std::unique_ptr<Associator> inner)
      : options_(options), inner_(std::move(inner)) {
    if (inner_ == nullptr) throw std::invalid_argument("ranking needs an exact algorithm inside");
    if (options.choices < 1) throw std::invalid_argument("the number of choices is at least 1");
  }

  [[nodiscard]] Traits traits() const noexcept override { return inner_->traits(); }

  [[nodiscard]] Verdict can_solve(const Shape& shape) const override {
    return inner_->can_solve(shape);
  }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    return Ranking(problem, *inner_, budget).run(options_.choices);
  }

 private:
  MurtyOptions options_;
  std::unique_ptr<Associator> inner_;
};

}  // namespace

std::unique_ptr<Associator> make_murty_k(const MurtyOptions& options,
                                         std::unique_ptr<Associator> inner) {
  return std::make_unique<MurtyK>(options, std::move(inner));
}

}  // namespace mda
