#include "algorithms/testing/tiny_problems.h"

#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>

namespace mda::testing {
namespace {

constexpr RowUse kMost = RowUse::kAtMostOnce;
constexpr RowUse kOnce = RowUse::kExactlyOnce;

struct Row {
  int dimension;
  RowUse use;
};

struct Column {
  double cost;
  std::vector<int> rows;
};

AssociationProblem make(const std::vector<Row>& rows, const std::vector<Column>& columns) {
  ProblemBuilder builder;
  for (const Row& row : rows) builder.add_row(row.dimension, row.use);
  for (const Column& column : columns) builder.add_column(column.cost, column.rows);
  return builder.build();
}

/// Nothing at all.
TinyProblem empty() { return {"empty", AssociationProblem(), 0.0, 0.0}; }

/// Two plots that nothing explains: both are clutter.
///
///     p .    q .
TinyProblem no_columns() { return {"no columns", make({{1, kMost}, {2, kMost}}, {}), 0.0, 0.0}; }

/// One possible track.
///
///     p o---o q    -3
TinyProblem one_column() {
  return {"one column", make({{1, kMost}, {2, kMost}}, {{-3.0, {0, 1}}}), -3.0, -3.0};
}

/// Every track costs more than calling its plots clutter.
///
///     p o---o q    +1        p o    +2
TinyProblem all_positive() {
  return {"all positive", make({{1, kMost}, {2, kMost}}, {{1.0, {0, 1}}, {2.0, {0}}}), 0.0, 0.0};
}

/// Two tracks of equal cost want the same plot.
///
///     p o---o q    -2
///           |
///     r o---+      -2
TinyProblem tie() {
  return {"tie", make({{1, kMost}, {2, kMost}, {1, kMost}}, {{-2.0, {0, 1}}, {-2.0, {2, 1}}}), -2.0,
          -2.0};
}

/// The odd cycle: each two of three tracks share a plot, so only one can be, but the relaxation
/// takes half of each.
///
///          p
///      -2 / \ -2
///        q---r
///         -2
TinyProblem triangle() {
  return {
      "triangle",
      make({{1, kMost}, {2, kMost}, {3, kMost}}, {{-2.0, {0, 1}}, {-2.0, {1, 2}}, {-2.0, {0, 2}}}),
      -2.0, -3.0};
}

/// The same with one better track, the last.
///
///          p
///      -2 / \ -2.5
///        q---r
///         -2
TinyProblem lopsided_triangle() {
  return {
      "lopsided triangle",
      make({{1, kMost}, {2, kMost}, {3, kMost}}, {{-2.0, {0, 1}}, {-2.0, {1, 2}}, {-2.5, {0, 2}}}),
      -2.5, -3.25};
}

/// The odd cycle of five: two whole tracks, or five halves. Scans 1 2 1 2 3 around the cycle.
///
///          p
///        /   \ .
///       q     t      each side -1
///        \   /
///        r---s
TinyProblem pentagon() {
  return {"pentagon",
          make({{1, kMost}, {2, kMost}, {1, kMost}, {2, kMost}, {3, kMost}},
               {{-1.0, {0, 1}}, {-1.0, {1, 2}}, {-1.0, {2, 3}}, {-1.0, {3, 4}}, {-1.0, {0, 4}}}),
          -2.0, -2.5};
}

/// Taking the best track first is a mistake.
///
///     p o-----o q      -5       p o   -3       q o   -3
TinyProblem greedy_trap() {
  return {"greedy trap", make({{1, kMost}, {2, kMost}}, {{-5.0, {0, 1}}, {-3.0, {0}}, {-3.0, {1}}}),
          -6.0, -6.0};
}

/// A fixed track T may coast or take the plot p; p may also start a track of its own with q.
///
///     T ===    -1        T ===o p    -4        p o---o q    -3.5
TinyProblem coasting_track() {
  return {"coasting track",
          make({{0, kMost}, {1, kMost}, {2, kMost}}, {{-1.0, {0}}, {-4.0, {0, 1}}, {-3.5, {1, 2}}}),
          -4.5, -4.5};
}

/// A fixed track that must go on, though every way costs something.
///
///     T ===    +5        T ===o p    +4
TinyProblem must_go_on() {
  return {"must go on", make({{0, kOnce}, {1, kMost}}, {{5.0, {0}}, {4.0, {0, 1}}}), 4.0, 4.0};
}

/// Two fixed tracks that must go on want one plot; the one that coasts worse should get it.
///
///     S ===    +3        S ===.
///                              o p    -1 for S, -2 for T
///     T ===    +1        T ==='
TinyProblem rivals_for_a_plot() {
  return {"rivals for a plot",
          make({{0, kOnce}, {0, kOnce}, {1, kMost}},
               {{3.0, {0}}, {1.0, {1}}, {-1.0, {0, 2}}, {-2.0, {1, 2}}}),
          0.0, 0.0};
}

/// Two fixed tracks that must both take the only plot.
///
///     S ===o p        T ===o p
TinyProblem one_plot_for_two() {
  return {"one plot for two",
          make({{0, kOnce}, {0, kOnce}, {1, kMost}}, {{-1.0, {0, 2}}, {-1.0, {1, 2}}}),
          std::nullopt, std::nullopt};
}

/// The triangle with plots that must be used: half of each track fills them, no choice does.
TinyProblem triangle_that_must() {
  return {
      "triangle that must",
      make({{1, kOnce}, {2, kOnce}, {3, kOnce}}, {{-2.0, {0, 1}}, {-2.0, {1, 2}}, {-2.0, {0, 2}}}),
      std::nullopt, -3.0};
}

/// A plot that must be used, and nothing that uses it.
TinyProblem nothing_fills_it() {
  return {"nothing fills it", make({{1, kOnce}, {2, kMost}}, {{-1.0, {1}}}), std::nullopt,
          std::nullopt};
}

/// The example of Lee and Jeong (figure 2): two targets, three plots, the middle one in both gates.
/// Eight events if a target may go without a plot. The costs are ours.
///
///     S ===o p   -2      S ===.
///                              o q    -1 for S, -3 for T
///     T ===o r   -1      T ==='
TinyProblem two_gates() {
  return {"two gates",
          make({{0, kMost}, {0, kMost}, {1, kMost}, {1, kMost}, {1, kMost}},
               {{-2.0, {0, 2}}, {-1.0, {0, 3}}, {-3.0, {1, 3}}, {-1.0, {1, 4}}}),
          -5.0, -5.0};
}

/// The same when each target must take a plot, as their equation (2) has it: three events.
TinyProblem two_gates_that_must() {
  return {"two gates that must",
          make({{0, kOnce}, {0, kOnce}, {1, kMost}, {1, kMost}, {1, kMost}},
               {{-2.0, {0, 2}}, {-1.0, {0, 3}}, {-3.0, {1, 3}}, {-1.0, {1, 4}}}),
          -5.0, -5.0};
}

/// The dense axial problem of size 2, every index exactly once. Cost of (i, j, k) row by row:
///
///     i = 0:  4 1      i = 1:  7 2
///             3 9              5 6
///
/// Choices: 000+111 = 10, 001+110 = 6, 010+101 = 5, 011+100 = 16.
TinyProblem axial() {
  const std::vector<double> cost = {4.0, 1.0, 3.0, 9.0, 7.0, 2.0, 5.0, 6.0};
  std::vector<Column> columns;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      for (int k = 0; k < 2; ++k) {
        columns.push_back({cost[static_cast<std::size_t>(4 * i + 2 * j + k)], {i, 2 + j, 4 + k}});
      }
    }
  }
  return {"axial",
          make({{1, kOnce}, {1, kOnce}, {2, kOnce}, {2, kOnce}, {3, kOnce}, {3, kOnce}}, columns),
          5.0, 5.0};
}

/// The example of Storms and Spieksma (figure 1): six scans A to F of 2, 1, 2, 3, 3 and 3 plots.
/// Three tracks, the first without a plot in scan E; A1 and E1 are false alarms. The costs are
/// ours: the true tracks, their parts, and rivals that use a false alarm or mix two tracks.
///
///     A2--B1--C2--D2------F3
///             C1--D3--E2--F1
///                 D1--E3--F2
///     A1                         E1
TinyProblem figure_1() {
  const std::vector<std::string> plots = {"A1", "A2", "B1", "C1", "C2", "D1", "D2",
                                          "D3", "E1", "E2", "E3", "F1", "F2", "F3"};
  std::map<std::string, int> number;
  std::vector<Row> rows;
  for (const std::string& plot : plots) {
    number[plot] = static_cast<int>(rows.size());
    rows.push_back({plot[0] - 'A' + 1, kMost});
  }
  const std::vector<std::pair<double, std::vector<std::string>>> tracks = {
      {-20.0, {"A2", "B1", "C2", "D2", "F3"}},
      {-16.0, {"C1", "D3", "E2", "F1"}},
      {-11.0, {"D1", "E3", "F2"}},
      {-17.0, {"A1", "B1", "C2", "D2", "F3"}},
      {-15.0, {"A2", "B1", "C2", "D2"}},
      {-12.0, {"C2", "D2", "E1", "F3"}},
      {-19.0, {"A2", "B1", "C1", "D3", "F1"}},
      {-14.0, {"C1", "D3", "E1", "F1"}},
      {-9.0, {"D3", "E2", "F1"}},
      {-8.0, {"D1", "E1", "F2"}},
      {-13.0, {"C2", "D2", "E2", "F3"}},
      {-7.0, {"D1", "E3"}},
      {-3.0, {"A1", "B1"}},
      {-2.0, {"E1", "F2"}}};
  std::vector<Column> columns;
  for (const auto& [cost, track] : tracks) {
    columns.push_back({cost, {}});
    for (const std::string& plot : track) columns.back().rows.push_back(number.at(plot));
  }
  return {"figure 1", make(rows, columns), -47.0, -47.0};
}

/// Two pairs out of two sensors, whatever they cost: the fragment of figure 1 in Bojilov 1995. k, l
/// are reports of the first sensor, m, n of the second.
///
///          m     n
///     k  13.2   6.3
///     l  35.7  11.8      13.2 + 11.8 = 25 < 42 = 6.3 + 35.7
TinyProblem forced_pairs() {
  return {"forced pairs",
          make({{1, kOnce}, {1, kOnce}, {2, kOnce}, {2, kOnce}},
               {{13.2, {0, 2}}, {6.3, {0, 3}}, {35.7, {1, 2}}, {11.8, {1, 3}}}),
          25.0, 25.0};
}

/// The same after the treatment: what is above Q = 9.21 costs Q* = 10, and the feasible pair wins.
///
///          m     n
///     k   10    6.3
///     l   10    10       10 + 6.3 = 16.3 < 20
TinyProblem treated_pairs() {
  return {"treated pairs",
          make({{1, kOnce}, {1, kOnce}, {2, kOnce}, {2, kOnce}},
               {{10.0, {0, 2}}, {6.3, {0, 3}}, {10.0, {1, 2}}, {10.0, {1, 3}}}),
          16.3, 16.3};
}

/// Distances as costs (Bojilov 1995, equation 1): where every report may stay alone at cost 0, it
/// had better, however near the others are.
///
///     sensor 1   o--1.0--o   sensor 2
///              1.5\    /0.8         triple: 1.5 + 0.8
///                   o   sensor 3
TinyProblem objective_trap() {
  return {"objective trap",
          make({{1, kMost}, {2, kMost}, {3, kMost}},
               {{1.0, {0, 1}}, {1.5, {0, 2}}, {0.8, {1, 2}}, {2.3, {0, 1, 2}}}),
          0.0, 0.0};
}

}  // namespace

const std::vector<TinyProblem>& tiny_problems() {
  static const std::vector<TinyProblem> kProblems = {
      empty(),         no_columns(),       one_column(),          all_positive(),
      tie(),           triangle(),         lopsided_triangle(),   pentagon(),
      greedy_trap(),   coasting_track(),   must_go_on(),          rivals_for_a_plot(),
      axial(),         one_plot_for_two(), triangle_that_must(),  nothing_fills_it(),
      figure_1(),      two_gates(),        two_gates_that_must(), forced_pairs(),
      treated_pairs(), objective_trap()};
  return kProblems;
}

const TinyProblem& tiny_problem(std::string_view name) {
  for (const TinyProblem& tiny : tiny_problems()) {
    if (tiny.name == name) return tiny;
  }
  throw std::out_of_range("no tiny problem is called " + std::string(name));
}

}  // namespace mda::testing
