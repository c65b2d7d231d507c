#include "algorithms/certified/kernel_search.h"

#include <algorithm>
#include <iterator>

#include "algorithms/certified/column_generation.h"
#include "algorithms/certified/recombination.h"
#include "algorithms/certified/swap_search.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

constexpr int kMostRounds = 12;  // of cuts
constexpr int kMostIdleRounds = 3;
constexpr int kIdleShare = 50;       // a round that closes less than 1/50 of the gap is idle
constexpr int kMostOddRowCuts = 40;  // per round
constexpr int kMostCliqueCuts = 20;
constexpr int kKicksAtRoot = 25;
constexpr int kKicksAtNode = 4;
constexpr std::size_t kMostChoices = 12;
constexpr int kMostDivisions = 32;
constexpr int kMostSteps = 25;  // of the simplex, on either side of a division

}  // namespace

KernelSearch::KernelSearch(const Part& part, Steps ceiling, const Budget& budget, Proof& proof)
    : packing_(part.packing),
      budget_(budget),
      proof_(proof),
      lp_(
          part.packing,
          [&] {
            Pricing pricing;
            price(part.packing, part.prices, pricing);
            return pricing.reduced;
          }(),
          budget),
      ceiling_(ceiling),
      root_bound_(part.bound),
      prices_(part.prices) {}

SearchResult KernelSearch::run() {
  cut_root();
  result_.complete = !stopped_;
  result_.floor = result_.complete ? ceiling_ : std::min(ceiling_, root_bound_);
  result_.iterations = lp_.iterations();
  return std::move(result_);
}

void KernelSearch::cut_root() {
  ++result_.nodes;
  int idle = 0;
  for (int round = 0;; ++round) {
    const Steps before = root_bound_;
    if (!solve_node(kKicksAtRoot)) return;
    recombine();
    root_bound_ = std::max(root_bound_, lp_.bound());
    kill(fix_columns());
    lp_.bury_the_dead();
    idle = (root_bound_ - before) < (ceiling_ - before) / kIdleShare ? idle + 1 : 0;
    if (round == kMostRounds || idle == kMostIdleRounds) break;
    lp_.drop_slack_cuts();
    if (!add_cuts()) break;
  }
  dive();
  recombine();
  if (!solve_node(0)) return;
  kill(fix_columns());
  branch();
}

/// Gives the LP the column that it likes best, and solves again, until it is whole or no better
/// than what is known: the way down finds choices that rounding does not.
void KernelSearch::dive() {
  std::vector<int> killed;
  for (;;) {
    constexpr double kIntegral = 1e-6;
    int best = -1;
    double largest = 0.0;
    for (const auto& [column, value] : point_) {
      if (value < largest || value > 1.0 - kIntegral) continue;
      largest = value;
      best = column;
    }
    if (best < 0) break;
    const std::vector<int> rivals = alive_rivals(packing_, alive_columns(), best);
    kill(rivals);
    killed.insert(killed.end(), rivals.begin(), rivals.end());
    if (lp_.solve(ceiling_) != Outcome::kOptimal || lp_.bound() > ceiling_ - kGrid) break;
    point_ = lp_.point();
    look_for_choices(kKicksAtNode);
  }
  revive(killed);
}

bool KernelSearch::add_cuts() {
  FractionalPoint fractional;
  constexpr double kIntegral = 1e-6;
  for (const auto& [column, value] : point_) {
    if (value < 1.0 - kIntegral) fractional.emplace_back(column, value);
  }
  std::vector<Cut> cuts = odd_row_cuts(packing_, lp_.alive(), fractional, kMostOddRowCuts);
  std::ranges::move(
      clique_cuts(packing_, lp_.alive(), lp_.pricing().reduced, fractional, kMostCliqueCuts),
      std::back_inserter(cuts));
  for (Cut& cut : cuts) {
    if (cut.kind == Cut::Kind::kOddRows) {
      proof_.odd_rows(packing_, cut.rows);
    } else {
      std::vector<int> members;
      for (const auto& [column, coefficient] : cut.columns) members.push_back(column);
      proof_.clique(packing_, members);
    }
    lp_.add(std::move(cut));
  }
  return !cuts.empty();
}

void KernelSearch::visit() {
  ++result_.nodes;
  if (!solve_node(kKicksAtNode)) return;
  const std::vector<int> fixed = fix_columns();
  kill(fixed);
  branch();
  revive(fixed);
}

bool KernelSearch::solve_node(int kicks) {
  if (!stopped_ && lp_.solve(ceiling_) != Outcome::kOptimal) stopped_ = true;
  if (stopped_) return false;
  point_ = lp_.point();
  if (lp_.bound() <= ceiling_ - kGrid) look_for_choices(kicks);
  if (lp_.bound() <= ceiling_ - kGrid) return true;
  record_prices();
  proof_.enumerate();
  return false;
}

/// Takes columns in the order of their LP values, and swaps from there.
void KernelSearch::look_for_choices(int kicks) {
  const Steps gap = ceiling_ - lp_.bound();
  SwapSearch swaps(packing_, lp_.row_prices(), lp_.pricing(), gap);
  swaps.start(columns_by_value(point_));
  swaps.improve(kicks, budget_);
  offer(swaps.choice());
  if (std::ranges::find(choices_, swaps.choice()) == choices_.end()) {
    if (choices_.size() == kMostChoices) choices_.erase(choices_.begin());
    choices_.push_back(swaps.choice());
  }
}

/// The latest choices and the columns of the LP point together.
void KernelSearch::recombine() {
  if (choices_.empty()) return;
  std::vector<char> alive(packing_.cost.size(), 0);
  for (const auto& [column, value] : point_) alive[index(column)] = 1;
  for (const std::vector<int>& choice : choices_) {
    for (const int j : choice) alive[index(j)] = 1;
  }
  offer(recombined(packing_, prices_, alive, choices_, budget_));
}

void KernelSearch::offer(const std::vector<int>& choice) {
  const Steps cost = cost_of(packing_, choice);
  if (cost >= ceiling_) return;
  ceiling_ = cost;
  result_.choice = choice;
}

/// The alive columns that no choice below the ceiling can have.
std::vector<int> KernelSearch::fix_columns() {
  std::vector<int> fixed;
  const Pricing& pricing = lp_.pricing();
  const Steps most = ceiling_ - kGrid - pricing.bound;
  for (const int j : lp_.living()) {
    if (lp_.is_alive(j) && pricing.reduced[index(j)] - lp_.least_beside(j) > most) {
      fixed.push_back(j);
    }
  }
  if (!fixed.empty()) record_prices();
  return fixed;
}

std::vector<int> KernelSearch::alive_columns() const {
  std::vector<int> alive;
  std::ranges::copy_if(lp_.living(), std::back_inserter(alive),
                       [&](int j) { return lp_.is_alive(j); });
  return alive;
}

void KernelSearch::branch() {
  const std::vector<int> alive = alive_columns();
  const Division division = best_division(alive);
  if (division.with.empty()) {
    close_without_rivals(alive);
    return;
  }
  if (division.column >= 0) {
    proof_.column(packing_, division.column);
  } else {
    proof_.row_pair(packing_, division.rows.first, division.rows.second);
  }
  visit_without(division.with);
  visit_without(division.without);
}

/// By the product of what both sides gain.
Division KernelSearch::best_division(const std::vector<int>& alive) {
  const double most = lp_.units(ceiling_) - lp_.value();
  const auto counted = [most](double gain) {
    constexpr double kLeastShare = 1e-3;  // so that the other side counts where one gains nothing
    return std::clamp(gain, kLeastShare * most, most);
  };
  Division best;
  double largest = -1.0;
  for (const RowPair& rows : halved_pairs(packing_, point_, kMostDivisions)) {
    Division division;
    const auto known = gains_.find(rows);
    if (known == gains_.end()) {
      division = division_by(packing_, alive, rows);
      if (!division.divides()) continue;
    }
    const Gains gains = known == gains_.end() ? try_out(division) : known->second;
    const double score = counted(gains.with) * counted(gains.without);
    if (score <= largest) continue;
    if (known != gains_.end()) division = division_by(packing_, alive, rows);
    if (!division.divides()) continue;
    best = std::move(division);
    largest = score;
  }
  return largest < 0.0 ? division_by_column(packing_, alive, point_) : best;
}

/// Strong branching, Applegate, Bixby, Chvatal and Cook 1995. What was found is not looked for
/// again, as pseudocosts are not: pairs of rows come up in one node after the other.
KernelSearch::Gains KernelSearch::try_out(const Division& division) {
  const double value = lp_.value();
  const Gains gains = {lp_.value_without(division.with, kMostSteps) - value,
                       lp_.value_without(division.without, kMostSteps) - value};
  gains_[division.rows] = gains;
  return gains;
}

/// No two alive columns share a row: all of them together are the best there is.
void KernelSearch::close_without_rivals(const std::vector<int>& alive) {
  offer(alive);
  const std::vector<Steps> nothing(index(packing_.rows()), 0);
  proof_.prices(packing_, nothing);
  proof_.enumerate();
}

void KernelSearch::visit_without(const std::vector<int>& columns) {
  if (stopped_) return;
  kill(columns);
  visit();
  revive(columns);
}

void KernelSearch::kill(const std::vector<int>& columns) {
  for (const int j : columns) lp_.kill(j);
}

void KernelSearch::revive(const std::vector<int>& columns) {
  for (const int j : columns) lp_.revive(j);
}

void KernelSearch::record_prices() { proof_.prices(packing_, lp_.row_prices(), lp_.cut_prices()); }

}  // namespace mda
