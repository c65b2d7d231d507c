#include <algorithm>
#include <limits>
#include <set>

#include "algorithms/certified/cuts.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr double kLeastBroken = 1e-3;  // of w(S) below 1
constexpr int kMostRows = 11;          // in S
constexpr int kNone = -1;

/// The rows that fractional columns use, and how they hang together.
class FractionalRows {
 public:
  FractionalRows(const Packing& packing, const FractionalPoint& x)
      : number_(index(packing.rows()), -1) {
    for (const auto& [column, value] : x) {
      std::vector<int>& rows = rows_of_.emplace_back();
      for (const int r : packing.rows_of(column)) {
        if (number_[index(r)] < 0) {
          number_[index(r)] = static_cast<int>(row_.size());
          row_.push_back(r);
          columns_of_.emplace_back();
          slack_.push_back(1.0);
        }
        const int i = number_[index(r)];
        rows.push_back(i);
        columns_of_[index(i)].push_back(static_cast<int>(value_.size()));
        slack_[index(i)] -= value;
      }
      value_.push_back(value);
    }
    for (double& slack : slack_) slack = std::max(0.0, slack);
    find_neighbours();
  }

  [[nodiscard]] int rows() const { return static_cast<int>(row_.size()); }
  [[nodiscard]] int columns() const { return static_cast<int>(value_.size()); }
  [[nodiscard]] int row(int i) const { return row_[index(i)]; }
  [[nodiscard]] double slack(int i) const { return slack_[index(i)]; }
  [[nodiscard]] double value(int column) const { return value_[index(column)]; }
  [[nodiscard]] const std::vector<int>& columns_of(int i) const { return columns_of_[index(i)]; }
  [[nodiscard]] const std::vector<int>& neighbours(int i) const { return neighbours_[index(i)]; }

 private:
  void find_neighbours() {
    neighbours_.resize(row_.size());
    for (int i = 0; i < rows(); ++i) {
      std::vector<int>& found = neighbours_[index(i)];
      for (const int c : columns_of_[index(i)]) {
        for (const int other : rows_of_[index(c)]) {
          if (other != i) found.push_back(other);
        }
      }
      std::ranges::sort(found);
      found.erase(std::unique(found.begin(), found.end()), found.end());
    }
  }

  std::vector<int> number_;
  std::vector<int> row_;
  std::vector<double> slack_;
  std::vector<std::vector<int>> columns_of_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<std::vector<int>> rows_of_;
  std::vector<double> value_;
};

/// A set of rows that knows w(S).
class RowSet {
 public:
  explicit RowSet(const FractionalRows& point)
      : point_(point), odd_(index(point.columns()), 0), in_(index(point.rows()), 0) {}

  void clear() {
    while (!rows_.empty()) flip(rows_.back());
    weight_ = 0.0;
  }

  /// Adds the row, or takes it out again.
  void flip(int row) {
    weight_ += change(row);
    for (const int c : point_.columns_of(row)) odd_[index(c)] ^= 1;
    in_[index(row)] ^= 1;
    if (in_[index(row)] != 0) {
      rows_.push_back(row);
    } else {
      std::erase(rows_, row);
    }
  }

  [[nodiscard]] double change(int row) const {
    double change = in_[index(row)] != 0 ? -point_.slack(row) : point_.slack(row);
    for (const int c : point_.columns_of(row)) {
      change += odd_[index(c)] != 0 ? -point_.value(c) : point_.value(c);
    }
    return change;
  }

  [[nodiscard]] double weight() const { return weight_; }
  [[nodiscard]] bool has(int row) const { return in_[index(row)] != 0; }
  [[nodiscard]] const std::vector<int>& rows() const { return rows_; }

 private:
  const FractionalRows& point_;
  std::vector<char> odd_;
  std::vector<char> in_;
  std::vector<int> rows_;
  double weight_ = 0.0;
};

struct Candidate {
  double weight;
  std::vector<int> rows;  // ascending
  bool operator<(const Candidate& other) const {
    return weight < other.weight || (weight == other.weight && rows < other.rows);
  }
};

class OddRowSearch {
 public:
  explicit OddRowSearch(const FractionalRows& point) : point_(point), set_(point) {}

  std::set<Candidate> run() {
    for (int a = 0; a < point_.rows(); ++a) {
      set_.clear();
      set_.flip(a);
      add_best_pair(a);
    }
    return std::move(found_);
  }

 private:
  /// Adds to S, which has `start`, the two rows that help most, again and again.
  void add_best_pair(int start) {
    std::vector<int> border = point_.neighbours(start);
    while (std::ssize(set_.rows()) + 2 <= kMostRows) {
      double best = std::numeric_limits<double>::infinity();
      std::pair<int, int> pair = {kNone, kNone};
      for (const int b : border) {
        if (set_.has(b)) continue;
        set_.flip(b);
        const auto consider = [&](const std::vector<int>& rows) {
          for (const int c : rows) {
            if (set_.has(c)) continue;
            const double weight = set_.weight() + set_.change(c);
            if (set_.rows().size() == 2 && weight < 1.0 - kLeastBroken) keep(weight, c);
            if (weight >= best) continue;
            best = weight;
            pair = {b, c};
          }
        };
        consider(border);
        consider(point_.neighbours(b));
        set_.flip(b);
      }
      if (pair.first < 0) return;
      set_.flip(pair.first);
      set_.flip(pair.second);
      if (set_.rows().size() > 3 && set_.weight() < 1.0 - kLeastBroken) {
        keep(set_.weight(), kNone);
      }
      for (const int row : {pair.first, pair.second}) {
        border.insert(border.end(), point_.neighbours(row).begin(), point_.neighbours(row).end());
      }
      std::ranges::sort(border);
      border.erase(std::unique(border.begin(), border.end()), border.end());
    }
  }

  /// S, with `row` if that is one.
  void keep(double weight, int row) {
    Candidate candidate{weight, set_.rows()};
    if (row != kNone) candidate.rows.push_back(row);
    std::ranges::sort(candidate.rows);
    found_.insert(std::move(candidate));
  }

  const FractionalRows& point_;
  RowSet set_;
  std::set<Candidate> found_;
};

}  // namespace

std::vector<Cut> odd_row_cuts(const Packing& packing, std::span<const char> alive,
                              const FractionalPoint& x, int most) {
  const FractionalRows point(packing, x);
  std::vector<Cut> cuts;
  std::vector<char> in_set(index(packing.rows()), 0);
  std::vector<int> uses(index(packing.rows()), 0);
  constexpr int kMostUses = 6;  // of a row in one round's cuts: they would say much the same
  for (const Candidate& candidate : OddRowSearch(point).run()) {
    if (std::ssize(cuts) == most) break;
    Cut cut;
    for (const int i : candidate.rows) cut.rows.push_back(point.row(i));
    if (std::ranges::any_of(cut.rows, [&](int r) { return uses[index(r)] >= kMostUses; })) continue;
    cut.right_hand_side = static_cast<int>(cut.rows.size()) / 2;
    for (const int r : cut.rows) {
      ++uses[index(r)];
      in_set[index(r)] = 1;
    }
    for (int j = 0; j < packing.columns(); ++j) {
      if (alive[index(j)] == 0) continue;
      int hits = 0;
      for (const int r : packing.rows_of(j)) hits += in_set[index(r)];
      if (hits >= 2) cut.columns.emplace_back(j, hits / 2);
    }
    for (const int r : cut.rows) in_set[index(r)] = 0;
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

}  // namespace mda
