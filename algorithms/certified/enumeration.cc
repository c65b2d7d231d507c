#include "algorithms/certified/enumeration.h"

#include <algorithm>
#include <span>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kNone = -1;

class Enumerator {
 public:
  Enumerator(const Packing& packing, const std::vector<Steps>& prices, const Pricing& pricing,
             Steps ceiling, int most_nodes, const Budget& budget)
      : packing_(packing),
        prices_(prices),
        reduced_(pricing.reduced),
        budget_(budget),
        most_nodes_(most_nodes),
        most_paid_(ceiling - kGrid - pricing.bound),
        decided_(index(packing.rows()), 0),
        ways_(index(packing.rows()), 0) {}

  Enumeration run() {
    std::vector<int> columns;
    for (int j = 0; j < packing_.columns(); ++j) {
      if (reduced_[index(j)] <= most_paid_) columns.push_back(j);
    }
    visit(columns, 0);
    result_.complete = !stopped_;
    return std::move(result_);
  }

 private:
  /// `columns` still fit and can be paid for; `paid`: for columns chosen and rows left free so far.
  void visit(const std::vector<int>& columns, Steps paid) {
    ++result_.nodes;
    constexpr int kNodesPerLookAtTheClock = 256;
    stopped_ = stopped_ || result_.nodes > most_nodes_ ||
               (result_.nodes % kNodesPerLookAtTheClock == 0 && budget_.expired());
    if (stopped_) return;
    std::ranges::fill(ways_, 0);
    for (const int j : columns) {
      for (const int r : packing_.rows_of(j)) ++ways_[index(r)];
    }
    int row = kNone;
    Steps lost = 0;  // on rows that no column is left for
    for (int r = 0; r < packing_.rows(); ++r) {
      if (decided_[index(r)] != 0 || prices_[index(r)] == 0) continue;
      if (ways_[index(r)] == 0) {
        lost += prices_[index(r)];
      } else if (row == kNone || ways_[index(r)] < ways_[index(row)]) {
        row = r;
      }
    }
    if (paid + lost > most_paid_) return;
    if (row == kNone) {  // whatever could be added now would only cost
      most_paid_ = paid + lost - kGrid;
      result_.choice = chosen_;
      return;
    }
    branch(columns, row, paid);
  }

  /// The row used by one of its columns, or left free.
  void branch(const std::vector<int>& columns, int row, Steps paid) {
    for (const int j : columns) {
      const auto rows = packing_.rows_of(j);
      if (std::ranges::find(rows, row) == rows.end()) continue;
      chosen_.push_back(j);
      decide(rows, columns, paid + reduced_[index(j)]);
      chosen_.pop_back();
    }
    decide({&row, 1}, columns, paid + prices_[index(row)]);
  }

  void decide(std::span<const int> rows, const std::vector<int>& columns, Steps paid) {
    if (paid > most_paid_ || stopped_) return;
    for (const int r : rows) decided_[index(r)] = 1;
    std::vector<int> left;
    for (const int j : columns) {
      const auto needs = packing_.rows_of(j);
      if (paid + reduced_[index(j)] > most_paid_) continue;
      if (std::ranges::none_of(needs, [&](int r) { return decided_[index(r)] != 0; })) {
        left.push_back(j);
      }
    }
    visit(left, paid);
    for (const int r : rows) decided_[index(r)] = 0;
  }

  const Packing& packing_;
  const std::vector<Steps>& prices_;
  const std::vector<Steps>& reduced_;
  const Budget& budget_;
  int most_nodes_;
  Steps most_paid_;
  std::vector<char> decided_;  // per row, used or left free
  std::vector<int> ways_;      // per row, columns left
  std::vector<int> chosen_;
  bool stopped_ = false;
  Enumeration result_;
};

}  // namespace

Enumeration enumerate(const Packing& packing, const std::vector<Steps>& prices,
                      const Pricing& pricing, Steps ceiling, int most_nodes, const Budget& budget) {
  return Enumerator(packing, prices, pricing, ceiling, most_nodes, budget).run();
}

}  // namespace mda
