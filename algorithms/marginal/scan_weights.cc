#include "algorithms/marginal/scan_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kNone = -1;

/// ln of a sum of weights given by their logarithms.
class LogSum {
 public:
  void add(double log_weight) {
    if (log_weight > largest_) {
      sum_ = sum_ * std::exp(largest_ - log_weight) + 1.0;
      largest_ = log_weight;
    } else {
      sum_ += std::exp(log_weight - largest_);
    }
  }

  /// Of at least one weight.
  [[nodiscard]] double value() const { return largest_ + std::log(sum_); }

 private:
  double largest_ = -std::numeric_limits<double>::infinity();
  double sum_ = 0.0;
};

/// A column that is a pair, in the order of the pairs.
struct PairColumn {
  int component;
  int track_row;
  int plot_row;
  int column;

  [[nodiscard]] bool same_pair(const PairColumn& other) const {
    return track_row == other.track_row && plot_row == other.plot_row;
  }
};

std::vector<PairColumn> sorted_pairs(const AssociationProblem& problem) {
  std::vector<PairColumn> pairs;
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    if (rows.size() < 2) continue;
    const bool in_order = problem.dimension(rows.front()) < problem.dimension(rows.back());
    pairs.push_back({problem.component_of_column()[index(j)], in_order ? rows.front() : rows.back(),
                     in_order ? rows.back() : rows.front(), j});
  }
  std::sort(pairs.begin(), pairs.end(), [](const PairColumn& a, const PairColumn& b) {
    return std::tie(a.component, a.track_row, a.plot_row, a.column) <
           std::tie(b.component, b.track_row, b.plot_row, b.column);
  });
  return pairs;
}

}  // namespace

void ScanWeights::read(const AssociationProblem& problem) {
  clusters_.clear();
  pair_track_row_.clear();
  pair_plot_row_.clear();
  first_row_.clear();
  for (int j = 0; j < problem.columns(); ++j) first_row_.push_back(problem.rows_of(j).front());
  pair_of_column_.assign(index(problem.columns()), kNone);
  share_.assign(index(problem.columns()), 0.0);
  number_of_row_.assign(index(problem.rows()), kNone);
  weigh_rests(problem);
  merge_pairs(problem);
}

void ScanWeights::weigh_rests(const AssociationProblem& problem) {
  std::vector<LogSum> rests(index(problem.rows()));
  for (int r = 0; r < problem.rows(); ++r) {
    if (problem.use(r) == RowUse::kAtMostOnce) rests[index(r)].add(0.0);
  }
  for (int j = 0; j < problem.columns(); ++j) {
    if (problem.rows_of(j).size() == 1) rests[index(first_row_[index(j)])].add(-problem.cost(j));
  }
  rest_.clear();
  for (const LogSum& rest : rests) rest_.push_back(rest.value());
  for (int j = 0; j < problem.columns(); ++j) {
    if (problem.rows_of(j).size() > 1) continue;
    share_[index(j)] = std::exp(-problem.cost(j) - rest_[index(first_row_[index(j)])]);
  }
}

void ScanWeights::merge_pairs(const AssociationProblem& problem) {
  const std::vector<PairColumn> pairs = sorted_pairs(problem);
  for (std::size_t i = 0; i < pairs.size();) {
    const PairColumn& first = pairs[i];
    if (i == 0 || first.component != pairs[i - 1].component) clusters_.emplace_back();
    LogSum sum;
    std::size_t end = i;
    for (; end < pairs.size() && pairs[end].same_pair(first); ++end) {
      sum.add(-problem.cost(pairs[end].column));
    }
    const double total = sum.value();
    for (; i < end; ++i) {
      const int column = pairs[i].column;
      pair_of_column_[index(column)] = static_cast<int>(pair_track_row_.size());
      share_[index(column)] = std::exp(-problem.cost(column) - total);
    }
    add_pair(first.track_row, first.plot_row);
    clusters_.back().log_weight.push_back(total - rest_[index(first.track_row)] -
                                          rest_[index(first.plot_row)]);
  }
}

void ScanWeights::add_pair(int track_row, int plot_row) {
  Cluster& cluster = clusters_.back();
  if (number_of_row_[index(track_row)] == kNone) {
    number_of_row_[index(track_row)] = cluster.tracks();
    cluster.track_begin.push_back(cluster.track_begin.back());
  }
  if (number_of_row_[index(plot_row)] == kNone) number_of_row_[index(plot_row)] = cluster.plots++;
  cluster.plot.push_back(number_of_row_[index(plot_row)]);
  ++cluster.track_begin.back();
  pair_track_row_.push_back(track_row);
  pair_plot_row_.push_back(plot_row);
}

std::vector<double> ScanWeights::columns(std::span<const double> pair_probability) const {
  std::vector<double> free(rest_.size(), 1.0);
  for (std::size_t p = 0; p < pair_probability.size(); ++p) {
    free[index(pair_track_row_[p])] -= pair_probability[p];
    free[index(pair_plot_row_[p])] -= pair_probability[p];
  }
  std::vector<double> x(share_.size());
  for (std::size_t j = 0; j < x.size(); ++j) {
    const int pair = pair_of_column_[j];
    const double whole = pair == kNone ? free[index(first_row_[j])] : pair_probability[index(pair)];
    x[j] = std::clamp(whole * share_[j], 0.0, 1.0);
  }
  return x;
}

}  // namespace mda
