#include "harness/certificate_check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "harness/certificate_cuts.h"
#include "harness/referee.h"

namespace mda {
namespace {

using Whole = std::int64_t;
__extension__ using Sum = __int128;  // of as many whole numbers as there may be

constexpr Whole kStepsPerUnit = 1024;         // prices are finer than costs
constexpr Whole kMostUnits = Whole{1} << 49;  // of a cost
constexpr Sum kLeastAtStake = Sum{1} << 30;   // units: see algorithms/api/certificate.h
constexpr Whole kMostSteps = Whole{1} << 59;  // of all prices together: no reduced cost overflows
constexpr int kMostDepth = 5000;
constexpr int kMostChoices = 20000;  // to enumerate, in one part
constexpr int kNone = -1;

using Numbers = std::vector<Whole>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

class Checker {
 public:
  Checker(const AssociationProblem& problem, const Certificate& certificate)
      : problem_(problem), steps_(certificate.steps), is_finest_(certificate.bits == kFinestBits) {
    demand(certificate.bits <= kFinestBits, "the costs are finer than they may be");
    const double units_per_nat = std::ldexp(1.0, certificate.bits);  // products with it are exact
    units_.reserve(columns_);
    for (const double cost : problem.costs()) {
      // Less than it costs proves less, and a choice must do without such a column.
      const double units = std::min(cost * units_per_nat, static_cast<double>(kMostUnits));
      demand(units > -static_cast<double>(kMostUnits), "a column gains too much for so many bits");
      units_.push_back(std::llrint(units));
    }
  }

  void check(std::span<const int> columns, Whole claimed) {
    check_choice(columns, claimed);
    const std::vector<int> alive = charge_exactly_once_rows();
    Sum floor = claimed;
    for (const Whole charge : charge_) floor -= charge;
    prove(alive, floor, 0, false);
    demand(next_ == steps_.size(), "there are steps after the end");
  }

 private:
  void check_choice(std::span<const int> columns, Whole claimed) const {
    std::vector<double> x(columns_, 0.0);
    Sum cost = 0;
    for (const int j : columns) {
      demand(x[index(column(j))] == 0.0, "the choice names a column twice");
      x[index(j)] = 1.0;
      demand(units_[index(j)] < kMostUnits, "a chosen column costs too much for so many bits");
      cost += units_[index(j)];
    }
    demand(examine(problem_, x).is_choice(), "the choice breaks a row");
    demand(cost == claimed, "the choice does not cost what is claimed");
  }

  /// Returns the columns that are below 0 after their exactly-once rows have been charged for their
  /// cheapest columns alone.
  std::vector<int> charge_exactly_once_rows() {
    std::vector<char> charged(index(problem_.rows()), 0);
    for (int j = 0; j < problem_.columns(); ++j) {
      const int r = problem_.rows_of(j)[0];
      if (problem_.rows_of(j).size() > 1 || problem_.use(r) == RowUse::kAtMostOnce) continue;
      const bool first = charged[index(r)] == 0;
      if (first || units_[index(j)] < charge_[index(r)]) charge_[index(r)] = units_[index(j)];
      charged[index(r)] = 1;
    }
    for (int r = 0; r < problem_.rows(); ++r) {
      demand(charged[index(r)] != 0 || problem_.use(r) == RowUse::kAtMostOnce,
             "an exactly-once row has no column of its own");
    }
    demand_precision();
    std::vector<int> alive;
    for (int j = 0; j < problem_.columns(); ++j) {
      Sum units = units_[index(j)];
      for (const int r : problem_.rows_of(j)) units -= charge_[index(r)];
      demand(units > -kMostUnits, "a column gains too much");
      units_[index(j)] = static_cast<Whole>(std::min<Sum>(units, kMostUnits));
      if (units < 0) alive.push_back(j);
    }
    return alive;
  }

  /// That rounding leaves something of what is at stake.
  void demand_precision() const {
    Sum at_stake = 0;
    for (const Whole charge : charge_) at_stake += std::abs(charge);
    Whole largest = 0;
    for (const Whole units : units_) largest = std::max(largest, -units);
    demand(is_finest_ || at_stake + largest >= kLeastAtStake, "the costs are rounded too coarsely");
  }

  /// That no choice of alive columns costs less than the floor, or Refused. If that is `proven`,
  /// the steps say no more: the solver needed them when it knew no choice as cheap as the one
  /// claimed.
  void prove(std::vector<int> alive, Sum floor, int depth, bool proven) {
    demand(depth < kMostDepth, "the proof is nested too deeply");
    const auto prove_without = [&](auto dies) {
      prove(without(alive, dies), floor, depth + 1, proven);
    };
    bool priced = proven;
    Sum spare = 0;  // what a choice below the floor may cost beyond the bound
    for (;;) {
      demand(next_ < steps_.size(), "the proof ends too soon");
      const ProofStep& step = steps_[next_++];
      switch (step.kind) {
        case ProofStep::Kind::kPrices:
          spare = (floor - 1) * kStepsPerUnit - reduce(step, alive);
          proven = proven || spare < 0;
          priced = true;
          std::erase_if(alive, [&](int j) { return proven || reduced_[index(j)] > spare; });
          break;
        case ProofStep::Kind::kOddRows:
          for (const int r : step.rows) (void)row(r);
          cuts_.add_odd_rows(step.rows);
          break;
        case ProofStep::Kind::kClique:
          for (const int j : step.columns) (void)column(j);
          cuts_.add_clique(step.columns);
          break;
        case ProofStep::Kind::kParts:
          prove_parts(step, alive, floor, depth, proven);
          return;
        case ProofStep::Kind::kRowPair: {
          demand(step.rows.size() == 2 && step.rows[0] != step.rows[1], "a pair is two rows");
          const auto hits = [&](int j) { return uses(j, step.rows[0]) + uses(j, step.rows[1]); };
          prove_without([&](int j) { return hits(j) == 1; });
          prove_without([&](int j) { return hits(j) == 2; });
          return;
        }
        case ProofStep::Kind::kColumn: {
          demand(step.columns.size() == 1, "a branch needs one column");
          const int chosen = column(step.columns[0]);
          prove_without([&](int j) { return j != chosen && rivals(problem_, j, chosen); });
          prove_without([&](int j) { return j == chosen; });
          return;
        }
        case ProofStep::Kind::kEnumerate:
          demand(
              priced && std::ranges::all_of(alive, [&](int j) { return reduced_[index(j)] >= 0; }),
              "choices are to be enumerated without prices that make all columns dear");
          choices_ = 0;
          if (!proven) enumerate(alive, spare);
          return;
      }
    }
  }

  template <typename Predicate>
  static std::vector<int> without(const std::vector<int>& columns, Predicate dies) {
    std::vector<int> left;
    std::ranges::remove_copy_if(columns, std::back_inserter(left), dies);
    return left;
  }

  static int checked(int number, int count) {
    demand(number >= 0 && number < count, "a step names a row, column or cut that is not there");
    return number;
  }
  [[nodiscard]] int row(int number) const { return checked(number, problem_.rows()); }
  [[nodiscard]] int column(int number) const { return checked(number, problem_.columns()); }
  [[nodiscard]] int uses(int column, int row) const {
    const auto rows = problem_.rows_of(column);
    return std::ranges::find(rows, row) == rows.end() ? 0 : 1;
  }
  /// Reduced costs of the alive columns; returns the bound.
  Sum reduce(const ProofStep& step, const std::vector<int>& alive) {
    std::ranges::fill(price_, 0);
    std::ranges::fill(cuts_.prices(), 0);
    Sum paid = 0;
    const auto pay = [&](const std::vector<int>& numbers, const std::vector<Whole>& amounts,
                         std::vector<Whole>& prices, const std::vector<Whole>* times) {
      demand(numbers.size() == amounts.size(), "a price is missing");
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        const int number = checked(numbers[i], static_cast<int>(prices.size()));
        demand(amounts[i] > 0 && prices[index(number)] == 0,
               "a price is not above 0, or there twice");
        paid += Sum{amounts[i]} * (times == nullptr ? 1 : (*times)[index(number)]);
        demand(paid < kMostSteps, "prices are too large");
        prices[index(number)] = amounts[i];
      }
    };
    pay(step.rows, step.prices, price_, nullptr);
    priced_rows_ = &step.rows;
    pay(step.cuts, step.cut_prices, cuts_.prices(), &cuts_.right_hand_side());
    Sum bound = -paid;
    for (const int j : alive) {
      reduced_[index(j)] = reduced(j);
      bound += std::min<Whole>(0, reduced_[index(j)]);
    }
    return bound;
  }

  [[nodiscard]] Whole reduced(int column) {
    Whole sum = units_[index(column)] * kStepsPerUnit + cuts_.price_of(column);
    for (const int r : problem_.rows_of(column)) sum += price_[index(r)];
    return sum;
  }

  void prove_parts(const ProofStep& step, const std::vector<int>& alive, Sum floor, int depth,
                   bool proven) {
    demand(step.part_rows.size() == step.part_floors.size(), "a part has no floor");
    demand(cuts_.count() == 0, "parts come after a cut");
    std::vector<int> part_of_row(index(problem_.rows()), kNone);
    for (int p = 0; p < std::ssize(step.part_rows); ++p) {
      for (const int r : step.part_rows[index(p)]) part_of_row[index(row(r))] = p;
      floor -= step.part_floors[index(p)];
    }
    demand(proven || floor <= 0, "the floors of the parts do not add up");
    std::vector<std::vector<int>> columns(step.part_rows.size());
    for (const int j : alive) {
      int part = kNone;  // one of its rows'; whatever rows it shares with other parts are let go
      for (const int r : problem_.rows_of(j)) part = std::max(part, part_of_row[index(r)]);
      demand(part != kNone, "a column is in no part");
      columns[index(part)].push_back(j);
    }
    for (std::size_t p = 0; p < columns.size(); ++p) {
      prove(std::move(columns[p]), step.part_floors[p], depth + 1, proven);
      cuts_ = CertificateCuts(problem_);
    }
  }

  /// With no reduced cost negative, a choice costs the bound, its columns' reduced costs, and the
  /// prices of the rows that it leaves free: that has to be more than there is to spare.
  void enumerate(const std::vector<int>& columns, Sum spare) {
    demand(++choices_ <= kMostChoices, "there are too many choices to try");
    for (const int r : *priced_rows_) ways_[index(r)] = 0;
    for (const int j : columns) {
      for (const int r : problem_.rows_of(j)) ++ways_[index(r)];
    }
    Sum lost = 0;  // on rows that no column is left for
    int row = kNone;
    for (const int r : *priced_rows_) {
      if (decided_[index(r)] != 0) continue;
      if (ways_[index(r)] == 0) lost += price_[index(r)];
      const bool is_fewer = row == kNone || ways_[index(r)] < ways_[index(row)];
      if (ways_[index(r)] > 0 && is_fewer) row = r;
    }
    if (lost > spare) return;
    demand(row != kNone, "a choice costs less than the floor");
    decide({&row, 1}, columns, spare - price_[index(row)]);
    for (const int j : columns) {
      if (uses(j, row) != 0) decide(problem_.rows_of(j), columns, spare - reduced_[index(j)]);
    }
  }

  void decide(std::span<const int> rows, const std::vector<int>& columns, Sum spare) {
    if (spare < 0) return;
    for (const int r : rows) decided_[index(r)] = 1;
    const auto dies = [&](int j) {
      const auto is_decided = [&](int r) { return decided_[index(r)] != 0; };
      return reduced_[index(j)] > spare || std::ranges::any_of(problem_.rows_of(j), is_decided);
    };
    enumerate(without(columns, dies), spare);
    for (const int r : rows) decided_[index(r)] = 0;
  }

  const AssociationProblem& problem_;
  const std::vector<ProofStep>& steps_;
  bool is_finest_;
  const std::size_t rows_ = index(problem_.rows());
  const std::size_t columns_ = index(problem_.columns());
  std::size_t next_ = 0;
  Numbers units_;                    // per column, its cost
  Numbers charge_ = Numbers(rows_);  // per row, units
  Numbers price_ = Numbers(rows_);
  Numbers reduced_ = Numbers(columns_);
  CertificateCuts cuts_ = CertificateCuts(problem_);
  // While enumerating, per row: used or left free; columns left; and the rows that have a price.
  std::vector<char> decided_ = std::vector<char>(rows_);
  Numbers ways_ = Numbers(rows_);
  const std::vector<int>* priced_rows_ = nullptr;
  int choices_ = 0;
};

}  // namespace

std::string certificate_fault(const AssociationProblem& problem, std::span<const int> columns,
                              const Certificate& certificate) {
  try {
    Checker(problem, certificate).check(columns, certificate.cost);
  } catch (const Refused& refused) {
    return refused.what();
  }
  return {};
}

}  // namespace mda
